#!/usr/bin/env bash
# rectilin validate from outside: verdicts, exit statuses, formats, counterexamples.  Usage: validate.sh RECTILIN
. "$(dirname "$0")/expect.sh"

expect 0 'eq-28' "$rectilin" validate --help
expect 0 '^theorem-2-1 ' "$rectilin" validate --list
expect 2 "no claim 'fermat'" "$rectilin" validate --claims fermat

# Everything, on the built-in shapes: what should hold does, and the status says so.
expect 0 '^claim' "$rectilin" validate
claims=$("$rectilin" validate --list | grep -c '^[a-z]')
[ "$(grep -cE 'holds +(holds|fails|untested)|fails +(holds|fails)' out)" -eq "$claims" ] || fail "a row for each claim"
[ -s err ] && fail "nothing on standard error"
for claim in eq-28-cubes eq-28-turned; do
  grep -qE "^$claim +fails +fails" out || fail "$claim fails, as expected"
  [ -s counterexamples/$claim.off ] && grep -q '"rotation"' counterexamples/$claim.json || fail "$claim: counterexample"
done

# A counterexample is one: its R is 1, and on the paper's box it is not.
expect 0 ' 1\.0000000000' "$rectilin" measure counterexamples/eq-28-cubes.off
expect 0 '^eq-28 +fails +fails' "$rectilin" validate --claims eq-28 counterexamples/eq-28-cubes.off

# Some claims, on some meshes, as JSON; a bad file costs a line and the status.
"$rectilin" convert shape:pyramid good.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >bad.off
expect 1 'bad\.off' "$rectilin" validate --json --claims eq-12,theorem-3-1 good.off bad.off shape:box
[ "$(wc -l <err)" -eq 1 ] || fail "one line for the bad file"
for key in claim source verdict margin counterexample; do
  [ "$(grep -c "\"$key\":" out)" -eq 2 ] || fail "$key of each claim"
done
grep -q '"tested": 2' out || fail "two meshes were tested"
touch file
expect 1 '^eq-28-cubes +fails +fails' "$rectilin" validate --claims eq-28-cubes --out file/folder
[ "$(wc -l <err)" -eq 1 ] || fail "one line for the counterexample that cannot be written"
mkdir empty
expect 1 'no mesh file' "$rectilin" validate empty

# The same for any number of threads; another seed, other poses.
run() { "$rectilin" validate --json --claims eq-28-turned,theorem-3-4,stable-150 shape:pyramid shape:torus "$@" | md5sum; }
one=$(run --threads 1)
[ "$one" = "$(run --threads 3)" ] && [ "$one" != "$(run --seed 2)" ] || fail "threads and seeds"

# Claims about retrieval need models with classes; without they are untested, which is no failure.
mkdir meshes; i=0
for shape in 'box?x=2&y=1' 'box?x=2.2&y=1' 'box?x=2&y=1.2' 'torus' 'torus?minor=0.35' 'torus?minor=0.45'; do
  "$rectilin" convert "shape:$shape" meshes/m$i.off || fail "convert $shape"; i=$((i + 1))
done
printf 'PSB 1\n2 6\nboxes 0 3\n0\n1\n2\ntori 0 3\n3\n4\n5\n' >all.cla
expect 0 '^r-improves +holds +untested' "$rectilin" validate --claims r-improves
expect 0 '^r-improves +holds +holds .* 6 +0 ' \
  "$rectilin" validate --claims r-improves --collection meshes --classes all.cla --cache signatures
[ -s signatures/r-*.jsonl ] || fail "signatures are kept"
expect 2 'needed together' "$rectilin" validate --claims r-improves --collection meshes
expect 1 'nowhere.cla: no such file or directory' \
  "$rectilin" validate --claims r-improves --collection meshes --classes nowhere.cla

finish validate
