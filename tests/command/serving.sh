# What the tests of the server share: shapes, a database of them, and servers that end with the script.
# Usage, after expect.sh: . "$(dirname "$0")/serving.sh"
"$rectilin" serve --help >/dev/null 2>&1 || { echo "skipped: built without libmicrohttpd"; exit 77; }
export TMPDIR=$work/temporary; mkdir "$TMPDIR"  # so that what is left behind is seen

mkdir -p meshes/more none
for i in 1 2 3 4; do
  "$rectilin" convert "shape:box?x=2&y=1.$i" meshes/box$i.off
  "$rectilin" convert "shape:torus?minor=0.3$i" meshes/torus$i.stl
  "$rectilin" convert "shape:stairs?steps=$((i + 2))" meshes/more/stairs$i.obj
done
"$rectilin" convert meshes/torus2.stl another.ply
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >broken.off
expect 0 '12 added' "$rectilin" index meshes -o shapes.db -d 'gsmd?views=6+0.5*r'

# start NAME ARGUMENT...: a server, with its address in $url and its process in $pid.
servers=()
start() {
  local name=$1; shift
  : >"$name.out"
  set -m  # so that it obeys Ctrl-C, see begin
  env --default-signal=INT,QUIT "$rectilin" serve --port 0 "$@" >"$name.out" 2>"$name.err" </dev/null &
  pid=$!
  set +m
  servers+=("$pid")
  for _ in $(seq 600); do grep -q 'http://' "$name.out" && break; kill -0 "$pid" 2>/dev/null || break; sleep 0.1; done
  url=$(grep -o 'http://[^ ]*' "$name.out" | head -n 1)
  [ -n "$url" ] || { fail "$name: no server"; cat "$name.out" "$name.err"; }
}
trap 'kill "${servers[@]}" 2>/dev/null; rm -rf "$work"' EXIT
