#!/usr/bin/env bash
# The command line from outside: rows, JSON, errors, exit statuses.  Usage: command.sh RECTILIN
set -uo pipefail
rectilin=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# expect STATUS PATTERN COMMAND...: the status, and a pattern somewhere in standard output or error.
expect() {
  local status=$1 pattern=$2 got; shift 2
  "$@" >out 2>err </dev/null; got=$?
  if [ $got -ne "$status" ] || ! grep -qE -- "$pattern" out err; then
    echo "FAILED: $* (status $got, expected $status and /$pattern/)"; cat out err
    failures=$((failures + 1))
  fi
}

expect 0 'measure' "$rectilin" --help
expect 0 'covering' "$rectilin" measure --help
expect 0 '[0-9]+\.[0-9]+' "$rectilin" --version
expect 2 'subcommand' "$rectilin"
expect 2 'source' "$rectilin" measure
expect 2 'domain' "$rectilin" measure shape:box --domain moon
expect 0 'population' "$rectilin" optimizers
expect 0 'deterministic, .*needs smooth' "$rectilin" optimizers
expect 0 '"name":"axis-sweep".*"capabilities":.*"needs_turns":true' "$rectilin" optimizers --json
expect 0 '"name":"box"' "$rectilin" shapes --json

expect 0 '^shape:box .* 3 .* 1\.0000000000' "$rectilin" measure -o grid shape:box
expect 0 '"directions":5.*"lower":null,"upper":null.*"rotation":\[\[' "$rectilin" measure --json -o ga shape:pyramid
expect 0 '"lower":0\.42705.*"upper":0\.42705' "$rectilin" measure --json shape:pyramid
expect 1 "no optimizer 'gaa'" "$rectilin" measure -o gaa shape:box
expect 1 "no parameter 'size'" "$rectilin" measure 'shape:box?size=1'
expect 1 'missing.off: ' "$rectilin" measure missing.off

# A bad file costs its own row.
"$rectilin" convert shape:pyramid good.off || failures=$((failures + 1))
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >bad.off
expect 1 'bad\.off:.*6' "$rectilin" measure good.off bad.off shape:box
[ "$(grep -c '^good.off\|^shape:box' out)" -eq 2 ] || { echo 'FAILED: rows of the good files'; failures=$((failures + 1)); }
expect 1 '"name":"bad.off","error"' "$rectilin" measure --json good.off bad.off
[ "$(wc -l <out)" -eq 2 ] || { echo 'FAILED: one JSON line per file'; failures=$((failures + 1)); }

# A list on standard input; folders; conversions that keep the measure.
printf 'good.off\nshape:box\n' | "$rectilin" measure --json - >out || failures=$((failures + 1))
[ "$(wc -l <out)" -eq 2 ] || { echo 'FAILED: list on standard input'; failures=$((failures + 1)); }
mkdir -p folder/below
for format in off obj ply stl; do "$rectilin" convert shape:pyramid folder/below/p.$format; done
expect 0 'folder/below/p.stl' "$rectilin" measure --json folder
[ "$(grep -o '"rectilinearity":[0-9.]*' out | cut -c1-27 | sort -u | wc -l)" -eq 1 ] ||
  { echo 'FAILED: formats agree'; cat out; failures=$((failures + 1)); }
mkdir empty
expect 1 'empty: no mesh file' "$rectilin" measure empty
expect 1 'unwritable' "$rectilin" convert shape:box unwritable/box.off
expect 1 'box.txt' "$rectilin" convert shape:box box.txt

# Same seed, same bits, for any number of threads; another seed, another run.
run() { "$rectilin" measure --json -o 'ga?generations=20' "$@" 'shape:blob?faces=5000' | grep -o '"digest":"[0-9a-f]*"'; }
one=$(run --threads 1)
[ "$one" = "$(run --threads 2)" ] && [ "$one" = "$(run --threads 8)" ] && [ "$one" != "$(run --seed 2)" ] ||
  { echo 'FAILED: digests'; failures=$((failures + 1)); }

[ $failures -eq 0 ] && echo "command: all as expected"
exit $((failures > 0))
