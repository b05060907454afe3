#!/usr/bin/env bash
# rectilin experiment from outside: the list, all of them small, with meshes, without gnuplot, interrupted.
# Usage: experiment.sh RECTILIN
. "$(dirname "$0")/expect.sh"

names="fig1 fig2 fig5 fig6 fig7 fig8 fig9 fig10 fig11 fig12 fig13 fig14 fig15 fig16 fig17 fig18 fig19 fig20 fig21 fig22
  table1 table2 table3 table4 table5 table6 pose-accuracy gallery gap shortfall"
expect 0 'rectilin experiment NAME' "$rectilin" experiment
for name in $names; do
  grep -qx "$name" out || fail "$name is listed"
done
expect 0 'fig15\?steps' "$rectilin" experiment --help
expect 2 "no experiment 'fig99'; did you mean 'fig9'" "$rectilin" experiment fig99
expect 2 "fig15.*stepz" "$rectilin" experiment 'fig15?stepz=3'
expect 2 'takes no others' "$rectilin" experiment fig15 shape:box
expect 2 'one experiment at a time' "$rectilin" experiment all shape:box

# All, small: a line each, files for every picture, a page that shows them and needs nothing else.
expect 0 'small/index.html' "$rectilin" experiment all --quick --out small
[ "$(grep -cE '^[a-z0-9-]+: ' out)" -eq "$(wc -w <<<"$names")" ] || fail "a line for each experiment"
for name in $names; do
  grep -q '"says": ".' "small/$name.json" || fail "$name says something"
  grep -q "id=\"$name\"" small/index.html || fail "the page has $name"
done
for csv in small/*.csv; do
  [ -s "${csv%.csv}.svg" ] || fail "$csv has a picture"
done
for picture in $(grep -oE 'src="[^"]*"' small/index.html | cut -d'"' -f2); do
  [ -s "small/$picture" ] || fail "the page shows $picture"
done
! grep -qE 'https?://' small/index.html || fail "the page is on its own"

# One more joins the page of its folder; a mesh that cannot be read costs its own place and the status.
expect 0 'is 1.0000 or more' "$rectilin" experiment 'fig15?steps=2' --out some
expect 1 'missing.off' "$rectilin" experiment fig11 shape:box missing.off shape:pyramid --out some
grep -q 'id="fig15"' some/index.html && grep -q 'id="fig11"' some/index.html || fail "the page has both"
expect 1 'missing.off' "$rectilin" experiment fig11 missing.off --out none
[ ! -e none ] || fail "nothing is written where nothing was measured"

# The same seed, the same numbers; another, others.
small=("$rectilin" experiment 'fig13?runs=2' 'shape:torus?slices=20&stacks=10' --gap 1e-4)
"${small[@]}" --out a >out && "${small[@]}" --threads 1 --out b >out && "${small[@]}" --seed 2 --out c >out
cmp -s a/fig13.csv b/fig13.csv || fail "the number of threads does not matter"
cmp -s a/fig13.csv c/fig13.csv && fail "the seed matters"

# Without gnuplot: one line, and all but the curves.
mkdir nothing
expect 0 'gnuplot is not installed' env PATH="$work/nothing" "$rectilin" experiment 'fig15?steps=2' --out bare
[ "$(wc -l <err)" -eq 1 ] && [ -s bare/index.html ] && [ -s bare/fig15-meshes.svg ] || fail "one line, and the rest"

# Ctrl-C: status 1 and one line.
begin "$rectilin" experiment 'fig13?runs=10000' --out long
sleep 0.5
kill -INT $pid
wait $pid
[ $? -eq 1 ] && [ "$(wc -l <err)" -eq 1 ] && grep -q 'stopped' err || fail "interrupted"
[ ! -e long ] || fail "nothing is left of what was stopped"

finish experiment
