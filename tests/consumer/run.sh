#!/usr/bin/env bash
# Installs the built tree into a temporary folder, then builds and runs a small project against it, with what only the
# experiments need hidden from it.
# Usage: run.sh CMAKE BUILD_DIR COMPILER
set -euo pipefail
cmake=$1 build=$2 compiler=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
hidden=()
for package in Ceres NLopt NLoptCxx Pagmo PNG CLI11 Catch2; do
  hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
"$cmake" --install "$build" --prefix "$work/prefix" >/dev/null
"$cmake" -S "$here" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_BUILD_TYPE=Release "${hidden[@]}" >/dev/null
"$cmake" --build "$work/build" >/dev/null
"$work/build/consumer"
