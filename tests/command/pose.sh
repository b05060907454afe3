#!/usr/bin/env bash
# rectilin pose from outside: tables, JSON, posed meshes, errors, exit statuses.  Usage: pose.sh RECTILIN
. "$(dirname "$0")/expect.sh"

box='shape:box?x=1&y=2&z=3&rotate=random&seed=3'
expect 0 'composite' "$rectilin" pose --help
expect 0 '^cpn' "$rectilin" poses
expect 0 '"name":"composite".*"parameters"' "$rectilin" poses --json
expect 2 'source' "$rectilin" pose
expect 2 "no pose method 'pcaa'; did you mean 'pca'" "$rectilin" pose --method pcaa shape:box
expect 2 'axes' "$rectilin" pose --axes sideways shape:box
expect 0 '^shape:box.* yes ' "$rectilin" pose "$box"
expect 0 '"name":.*"method":"cpn","chosen":"(pca|rectilinear)".*"rotation":\[\[.*"centre":\[.*"scale":.*"unique":true.*"candidates":\[\{' \
  "$rectilin" pose --json --method cpn "$box"
expect 0 '"unique":false,"uniqueness":"none"' "$rectilin" pose --json 'shape:sphere?kind=even&faces=2000'
expect 0 'round [xyz]' "$rectilin" pose 'shape:ellipsoid?a=3&b=1&c=1'

# The same for any number of threads.
"$rectilin" pose --json -t 1 "$box" shape:blob >one && "$rectilin" pose --json -t 4 "$box" shape:blob >four || fail 'threads'
cmp -s one four || fail 'other bits with other threads'

# Posed meshes: into a file, into a folder, in any format; two of one name; posing them again changes nothing.
expect 0 '' "$rectilin" pose "$box" --axes definite --write posed.ply
expect 0 ' 0\.000 ' "$rectilin" pose --axes definite posed.ply
mkdir meshes && "$rectilin" convert "$box" meshes/a.off && "$rectilin" convert shape:pyramid meshes/b.stl || fail convert
expect 0 '"file":"posed/b.obj"' "$rectilin" pose --json meshes --write posed --format obj
[ -s posed/a.obj ] && [ -s posed/b.obj ] || fail 'two files'
expect 0 '' "$rectilin" pose shape:box 'shape:box?x=2' --write twice
[ -s twice/box.off ] && [ -s twice/box-2.off ] || fail 'names told apart'
expect 2 'name a folder' "$rectilin" pose meshes --write one.off
expect 2 'would replace' "$rectilin" pose meshes/a.off --write meshes
expect 0 '' "$rectilin" pose meshes --sheet sheet.svg
[ "$(grep -c '<image' sheet.svg)" -eq 6 ] || fail 'three views of each'

# A bad file costs its own row; nothing is written for it, and no NaN anywhere.
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' >line.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >triangle.off
printf 'OFF\n3 1 0\n0 0 0\n1e120 0 0\n0 1e120 1e119\n3 0 1 2\n' >huge.off
printf 'OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n' >nan.off
expect 1 'line\.off: ' "$rectilin" pose --json line.off triangle.off huge.off nan.off --write bad
[ "$(wc -l <err)" -eq 2 ] || fail 'one line for each bad file'
[ "$(wc -l <out)" -eq 4 ] || fail 'one JSON line per file'
[ -s bad/triangle.off ] && [ -s bad/huge.off ] && [ ! -e bad/line.off ] && [ ! -e bad/nan.off ] || fail 'files of the good ones'
grep -qi 'nan\b.*nan\b' bad/*.off && fail 'NaN in a file'
expect 1 'cannot be written' "$rectilin" pose triangle.off --write /dev/null/x.off

# Every method: flat, a single triangle, parts far apart, a vertex far outside that no face uses (it goes with the others
# or is refused, but is no infinity in a file), and a sphere, which has no pose.
printf 'OFF\n4 2 0\n0 0 0\n4 0 0\n4 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >flat.off
printf 'OFF\n8 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1e9 0 0\n1000000001 0 0\n1e9 1 0\n1e9 0 1\n3 0 1 2\n3 0 1 3\n3 4 5 6\n3 4 6 7\n' >apart.off
printf 'OFF\n4 1 0\n0 0 0\n1e-9 0 0\n0 1e-9 0\n1e305 0 0\n3 0 1 2\n' >stray.off
"$rectilin" poses --json | grep -o '^{"name":"[a-z-]*"' | cut -d'"' -f4 >methods
[ "$(wc -l <methods)" -eq 10 ] || fail 'ten methods'
while read -r method; do
  expect 1 'stray\.off: ' "$rectilin" pose --json --method "$method" flat.off triangle.off apart.off huge.off stray.off --write "odd-$method"
  [ "$(ls "odd-$method" | wc -l)" -eq 4 ] || fail "files by $method"
  grep -qiE '(^| )-?(nan|inf)' "odd-$method"/*.off && fail "not finite by $method"
  grep -qE '(nan|inf)[,\]]' out && fail "not finite in JSON by $method"
  expect 0 '"uniqueness":"none"' "$rectilin" pose --json --method "$method" 'shape:sphere?kind=even&faces=3000'
done <methods

# Interrupted: what is written stays, whole; one line.
for i in $(seq 300); do cp meshes/a.off "meshes/c$i.off"; done
begin "$rectilin" pose meshes --method 'box?directions=20000' --write half --threads 1
for _ in $(seq 400); do [ -e half/a.off ] && break; sleep 0.05; done
kill -INT "$pid"
wait "$pid"
status=$?
[ $status -ne 0 ] && [ -s half/a.off ] && [ "$(ls half | wc -l)" -lt 302 ] || fail "interrupted (status $status)"
expect 0 '' "$rectilin" measure half
ls -A half | grep -v '\.off$' && fail 'something half written'

# Silhouettes as the objective of a comparison: gaps to the best found, none of them negative, and no optimizer that
# needs more than values.
expect 0 'sil/index.html' "$rectilin" compare shape:lshape --objective silhouette --runs 2 --budget 60 \
  --certificate 'super-fibonacci?count=200' -o 'random, super-fibonacci?count=50' --out sil
grep -q 'nothing can be proved' sil/index.html || fail 'the page says what the gap is'
awk -F, 'NR == 1 {for (i = 1; i <= NF; i++) if ($i == "gap") g = i} NR > 1 && $g < 0 {bad = 1} END {exit bad}' sil/runs.csv ||
  fail 'negative gaps'
expect 2 'another plan .objective silhouette' "$rectilin" compare shape:lshape --runs 2 --budget 60 -o random --out sil
expect 2 'objective' "$rectilin" compare shape:lshape --objective moon

finish pose
