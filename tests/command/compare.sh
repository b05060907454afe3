#!/usr/bin/env bash
# rectilin compare from outside: a small comparison, once, again, interrupted, without gnuplot.
# Usage: compare.sh RECTILIN
. "$(dirname "$0")/expect.sh"

expect 0 'ga@paper' "$rectilin" compare --help
expect 2 'source' "$rectilin" compare
expect 2 "no optimizer 'gaa'" "$rectilin" compare shape:box -o gaa
expect 2 'given twice' "$rectilin" compare shape:box -o ga,ga

small=("$rectilin" compare shape:box shape:pyramid -o 'ga,random,tight=grid?keep=1@zone' -k 3 -O small -b)
expect 0 'small/index.html' "${small[@]}" 300
[ "$(wc -l <small/runs.jsonl)" -eq 18 ] && [ "$(wc -l <small/runs.csv)" -eq 19 ] || fail "18 runs"
for file in index.html summary.json meshes.csv ert.csv tests.csv provenance.json; do
  [ -s "small/$file" ] || fail "$file is there"
done
grep -q "tight=grid" small/provenance.json || fail "the command line is on record"
[ "$(find small/ioh -name '*.dat' | wc -l)" -eq 6 ] || fail "data for IOHprofiler"
for csv in small/plots/*.csv; do
  [ -s "${csv%.csv}.gp" ] || fail "$csv has a gnuplot file"
  [ -s "${csv%.csv}.svg" ] || fail "$csv has a picture"
done
for picture in $(grep -oE 'src="[^"]*"' small/index.html | cut -d'"' -f2); do
  [ -s "small/$picture" ] || fail "the page shows $picture"
done

# Again: nothing is run twice. Another plan: refused.
sum=$(cksum <small/runs.jsonl)
expect 0 'small/index.html' "${small[@]}" 300
[ "$(cksum <small/runs.jsonl)" = "$sum" ] || fail "finished runs are not run again"
expect 2 'another plan \(budget 300, not 301\)' "${small[@]}" 301

# Domains as a factor.
expect 0 'domains/index.html' "$rectilin" compare shape:pyramid -o ga,random --domains paper,covering -k 2 -b 200 -O domains
grep -q 'What a domain costs' domains/index.html && grep -q 'ga@paper' domains/index.html || fail "the table of domains"

# A mesh that cannot be read costs its own row and the status.
expect 1 'missing.off' "$rectilin" compare missing.off shape:box -o random -k 2 -b 100 -O missing
grep -q '"shape:box"' missing/summary.json || fail "the other mesh"

expect 1 'missing.off' "$rectilin" compare missing.off -o random -k 2 -b 100 -O nothing-measured
[ "$(wc -l <err)" -eq 1 ] || fail "one line if no mesh can be read"

# Areas out of range; a certificate that is none, before anything is written.
printf 'OFF\n4 4 0\n0 0 0\n1e200 0 0\n0 1e200 0\n0 0 1e200\n3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n' >huge.off
expect 0 'huge/index.html' "$rectilin" compare huge.off -o random -k 2 -b 100 -O huge
expect 0 'huge/index.html' "$rectilin" compare huge.off -o random -k 2 -b 100 -O huge
expect 2 "no optimizer 'nope'" "$rectilin" compare shape:box -o random -k 2 -b 100 -O fresh -c nope
expect 2 'proves nothing' "$rectilin" compare shape:box -o random -k 2 -b 100 -O fresh -c ga
[ ! -e fresh ] || fail "nothing of a wrong command"

# Without gnuplot: one line, and all but the pictures.
mkdir nothing
expect 0 'gnuplot is not installed' env PATH="$work/nothing" "$rectilin" compare shape:box -o random -k 2 -b 100 -O bare
[ "$(wc -l <err)" -eq 1 ] && [ -s bare/index.html ] || fail "one line, and the page"

# Ctrl-C once a run is there: status 1, a line that says how to go on, whole lines only.
begin "$rectilin" compare shape:box -o random -k 100000 -b 20000 -O long
until [ -s long/runs.jsonl ] || ! kill -0 $pid 2>/dev/null; do sleep 0.05; done
"$rectilin" compare shape:box -o random -k 100000 -b 20000 -O long >out2 2>err2 </dev/null
[ $? -eq 1 ] && grep -q 'another program is writing here' err2 || fail "one program at a time"
kill -INT $pid
wait $pid
[ $? -eq 1 ] && [ "$(wc -l <err)" -eq 1 ] && grep -q 'the same command goes on' err || fail "interrupted"
[ "$(tail -c 2 long/runs.jsonl)" = "}" ] || fail "whole lines"

finish compare
