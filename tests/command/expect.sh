# What the end-to-end tests share: an empty folder to work in, and checks that go on after a failure.
# Usage, first of all: . "$(dirname "$0")/expect.sh"; at the end: finish NAME
set -uo pipefail
rectilin=$(realpath "$1")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

fail() { echo "FAILED: $*"; cat out err 2>/dev/null; failures=$((failures + 1)); }

# expect STATUS PATTERN COMMAND...: the status, and a pattern somewhere in standard output or error.
expect() {
  local status=$1 pattern=$2 got; shift 2
  "$@" >out 2>err </dev/null; got=$?
  [ $got -eq "$status" ] && grep -qE -- "$pattern" out err ||
    fail "$* (status $got, expected $status and /$pattern/)"
}

# begin COMMAND...: runs it beside this script, as $pid, with signals as a terminal gives them: without job control bash
# has commands behind & ignore SIGINT, and tests that were themselves begun so hand that down.
begin() {
  set -m
  env --default-signal=INT,QUIT "$@" >out 2>err </dev/null &
  pid=$!
  set +m
}

finish() {
  [ $failures -eq 0 ] && echo "$1: all as expected"
  exit $((failures > 0))
}
