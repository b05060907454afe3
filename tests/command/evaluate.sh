#!/usr/bin/env bash
# rectilin evaluate from outside: scores, files, resuming, matrices in and out, bad input.  Usage: evaluate.sh RECTILIN
. "$(dirname "$0")/expect.sh"

expect 0 'cla' "$rectilin" evaluate --help
expect 0 '^gsmd' "$rectilin" descriptors

# Three classes of three: boxes, tori and stairs; model 9 has no file, and class "nothing" no models.
mkdir meshes
i=0
for shape in 'box?x=2&y=1' 'box?x=2.2&y=1' 'box?x=2&y=1.2' 'torus' 'torus?minor=0.35' 'torus?minor=0.45' \
             'stairs' 'stairs?steps=4' 'stairs?steps=6'; do
  "$rectilin" convert "shape:$shape" meshes/m$i.off || fail "convert $shape"; i=$((i + 1))
done
cat >all.cla <<'C'
PSB 1
4 10

boxes 0 3
0
1
2
tori 0 3
3
4
5
stairs 0 4
6
7
8
9
nothing 0 0
C
run() { "$rectilin" evaluate meshes --classes all.cla -d 'd2, mine=r+0.5*d1' --out "${into:-scored}" "$@"; }
expect 0 '^mine ' run
grep -q 'no mesh file for 1 models: 9' err || fail "the missing model is named"
grep -q 'empty classes: nothing' err || fail "the empty class is named"
into=collection expect 0 '^d2@collection ' run --collection
grep -q '^mine ' out || fail "the plain scores, too"
[ "$(wc -c <collection/matrices/d2@collection.matrix)" -eq 324 ] || fail "the matrix by the collection"
cmp -s scored/matrices/d2.matrix collection/matrices/d2.matrix || fail "the plain distances are the same"
for file in index.html summary.json scores.csv classes.csv queries.csv tests.csv confusion.csv matrices/mine.matrix; do
  [ -s scored/$file ] || fail "$file"
done
[ "$(stat -c %s scored/matrices/d2.matrix)" -eq $((9 * 9 * 4)) ] || fail "size of the matrix"
[ "$(paste -sd, scored/matrices/d2.models)" = 0,1,2,3,4,5,6,7,8 ] || fail "rows of the matrix"
grep -q '"missing": \[' scored/summary.json || fail "missing models in the summary"

# Again: nothing is computed anew, and every number is the same for any number of threads.
cp -r scored first; lines=$(cat scored/features/*.jsonl | wc -l)
expect 0 '^mine ' run --threads 1
[ "$(cat scored/features/*.jsonl | wc -l)" -eq "$lines" ] || fail "features were computed again"
cmp -s scored/matrices/mine.matrix first/matrices/mine.matrix || fail "the same distances"
rm -r scored; expect 0 '^mine ' run --threads 1
cmp -s scored/matrices/mine.matrix first/matrices/mine.matrix || fail "the same distances with one thread"
# An end in the middle of a line loses that line only.
for file in scored/features/*.jsonl; do truncate -s -20 "$file"; done
expect 0 '^mine ' run
cmp -s scored/matrices/mine.matrix first/matrices/mine.matrix || fail "the same distances after an interruption"

# Stopped in between, it says so in one line, and goes on from there.
begin "$rectilin" evaluate meshes -c all.cla -d 'gsmd?views=258&size=512' --threads 1 --out stopped
for _ in $(seq 300); do grep -q signature stopped/features/*.jsonl 2>/dev/null && break; sleep 0.1; done
kill -INT $pid; wait $pid
[ $? -eq 1 ] && grep -q 'the same command goes on from here' err || fail "interrupted"
kept=$(cat stopped/features/*.jsonl | wc -l)
[ ! -e stopped/index.html ] || fail "a page of an evaluation that was stopped"
expect 0 '^gsmd' "$rectilin" evaluate meshes -c all.cla -d 'gsmd?views=258&size=512' --out stopped
[ "$(cat stopped/features/*.jsonl | wc -l)" -eq 10 ] && [ "$kept" -ge 2 ] || fail "what was computed is kept"

# No room on the disk: one line and a status; with room again nothing is lost.
(ulimit -f 3; trap '' XFSZ; "$rectilin" evaluate meshes -c all.cla -d d2 --out full >out 2>err)
[ $? -eq 1 ] && [ "$(wc -l <err)" -eq 1 ] && grep -q 'full/features' err || fail "a full disk"
expect 0 '^d2' "$rectilin" evaluate meshes -c all.cla -d d2 --out full
cmp -s full/matrices/d2.matrix first/matrices/d2.matrix || fail "the same distances after a full disk"

# Another collection's classes.
mkdir other; cp meshes/m0.off other/else.off
expect 1 'other: holds none of the models of all.cla' "$rectilin" evaluate other -c all.cla -d r --out nothing

# Matrices of others, of all ten models or of the nine.
head -c 400 /dev/zero >ten.matrix
expect 0 '^ten ' run --matrix ten.matrix --matrix again=first/matrices/d2.matrix
head -c 12 /dev/zero >bad.matrix
expect 1 'bad.matrix: has 12 bytes' run --matrix bad.matrix

# Signatures as the light field descriptor's own program has them, written and read: the distances of lfd:ntu.
mkdir nine; for i in 0 1 2 3 4 5 6 7 8; do cp meshes/m$i.off nine; done
expect 0 'art,fd,cir,ecc' "$rectilin" describe nine -d 'lfd:ntu' -O theirs
[ "$(ls theirs | wc -l)" -eq 36 ] && [ "$(stat -c %s theirs/m3.art theirs/m3.fd theirs/m3.cir theirs/m3.ecc | paste -sd,)" = 3500,1000,100,100 ] ||
  fail "the light field descriptor's files"
expect 0 '^theirs ' "$rectilin" evaluate meshes -c all.cla -d lfd:ntu --lfd theirs --lfd again=theirs/ -O fields
cmp -s fields/matrices/theirs.matrix fields/matrices/lfd:ntu.matrix || fail "distances of files read"
grep -q '"lfd_files": "theirs"' fields/summary.json || fail "the folder in the summary"
rm theirs/m4.fd
expect 1 'theirs/m4.fd: ' "$rectilin" evaluate meshes -c all.cla --lfd theirs -O fields
head -c 99 /dev/zero >theirs/m4.fd
expect 1 'theirs/m4.fd: has 99 bytes, not 1000' "$rectilin" evaluate meshes -c all.cla --lfd theirs -O fields
expect 1 'nowhere/m0.art' "$rectilin" evaluate meshes -c all.cla --lfd nowhere -O fields

# Signatures of any descriptor.
expect 0 ' 64  bytes.m0.signature' "$rectilin" describe meshes/m0.off -d 'd2?bins=16' -O bytes
expect 0 '"bytes":' "$rectilin" describe meshes/m0.off shape:box -d r --json
[ "$(wc -l <out)" -eq 2 ] || fail "a line for each mesh"
expect 2 'folder for the files' "$rectilin" describe meshes/m0.off
expect 2 "no descriptor 'nothing'" "$rectilin" describe meshes/m0.off -d nothing --json
expect 1 'none.off: no such file' "$rectilin" describe none.off meshes/m0.off -d r --json
grep -q m0.off out || fail "a mesh that fails costs only itself"
expect 2 'all.cla is a file' "$rectilin" describe meshes/m0.off -O all.cla

# Weights are tuned, written and read.
expect 0 '^ga: DCG' run --tune 'd2+r' --budget 60 --folds 3
expect 0 '^tuned ' "$rectilin" evaluate meshes -c all.cla -d 'tuned=@scored/weights.json' --out scored

# Bad input: one line, a status, and the rest is done.
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >meshes/m2.off
into=broken expect 1 'm2\.off' run
[ "$(paste -sd, broken/matrices/d2.models)" = 0,1,3,4,5,6,7,8 ] || fail "the mesh that fails is in no matrix"
printf 'PSB 1\n1 2\na 0 1\n0\n' >counts.cla
expect 1 'counts.cla:line' "$rectilin" evaluate meshes -c counts.cla -d d2 --out x
printf 'PSB 1\n2 2\na 0 1\n0\nb 0 1\n0\n' >twice.cla
expect 1 "twice.cla:line 6: model '0' is there twice" "$rectilin" evaluate meshes -c twice.cla -d d2 --out x
expect 1 'nowhere.cla: no such file or directory' "$rectilin" evaluate meshes -c nowhere.cla -d d2 --out x
expect 2 "no descriptor 'gsmt'" "$rectilin" evaluate meshes -c all.cla -d gsmt --out x
expect 2 'twice' "$rectilin" evaluate meshes -c all.cla -d d2,d2 --out x
expect 2 'descriptors need a folder' "$rectilin" evaluate -c all.cla -d d2 --out x
cp meshes/m0.off meshes/0.off
expect 1 "model '0' could be" "$rectilin" evaluate meshes -c all.cla -d d2 --out x

finish evaluate
