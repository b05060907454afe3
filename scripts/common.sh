# What the scripts share: steps that show their output only if they fail, installing packages, building.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(g++ cmake ninja-build xz-utils
  libeigen3-dev libtbb-dev libhwy-dev nlohmann-json3-dev libcli11-dev catch2 gnuplot-nox
  libnlopt-cxx-dev libceres-dev libpagmo-dev libmeshoptimizer-dev libqhull-dev libpng-dev libtinygltf-dev lib3mf-dev
  libarchive-dev libdeflate-dev libsqlite3-dev libhnswlib-dev libmicrohttpd-dev libbenchmark-dev libpolyclipping-dev
  python3-dev pybind11-dev python3-numpy python3-scipy python3-matplotlib python3-pytest python3-pip python3-setuptools
  python3-wheel)

# step TEXT COMMAND...: prints TEXT, runs the command, and shows its output only if it fails.
step() {
  local text=$1 log; shift
  log=$(mktemp)
  printf '%s ...' "$text" >&2
  local start=$SECONDS
  if "$@" >"$log" 2>&1; then
    printf ' done (%d s)\n' $((SECONDS - start)) >&2
    rm -f "$log"
  else
    local status=$?
    printf ' failed\n' >&2
    cat "$log" >&2
    rm -f "$log"
    exit "$status"
  fi
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

apt_install() {
  as_root env DEBIAN_FRONTEND=noninteractive apt-get update -q &&
    as_root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "$@"
}

# install_packages PACKAGE...: installs those that are missing; does nothing on systems without apt.
install_packages() {
  command -v apt-get >/dev/null || return 0
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] || step "Installing ${missing[*]}" apt_install "${missing[@]}"
}

# install_commands COMMAND...: installs the packages of these names unless there are such commands, from wherever: Node.js
# often comes with an npm of its own.
install_commands() {
  local missing=() command
  for command in "$@"; do
    command -v "$command" >/dev/null || missing+=("$command")
  done
  [ ${#missing[@]} -eq 0 ] || install_packages "${missing[@]}"
}

# build PRESET [CMAKE OPTION...]: configures in build/PRESET and builds the array `targets`, or all if it is empty.
targets=()
build() {
  local preset=$1; shift
  install_packages "${packages[@]}"
  install_commands npm  # fetches what shows shapes in 3D in the browser
  [ -z "${CI:-}" ] || set -- -DRECTILIN_WARNINGS_AS_ERRORS=ON "$@"
  step "Configuring ($preset)" cmake --preset "$preset" "$@"
  step "Building ($preset)" cmake --build --preset "$preset" ${targets[@]:+--target "${targets[@]}"}
}

# The command and the Python package, where people and scripts find them.
link_command() {
  ln -sfn release/app/rectilin build/rectilin
  ln -sfn release/python build/python
}
