#!/usr/bin/env bash
# The command line from outside: rows, JSON, errors, exit statuses.  Usage: command.sh RECTILIN
. "$(dirname "$0")/expect.sh"

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
expect 2 "no optimizer 'gaa'" "$rectilin" measure -o gaa shape:box
expect 1 "no parameter 'size'" "$rectilin" measure 'shape:box?size=1'
expect 1 'missing.off: ' "$rectilin" measure missing.off

expect 0 '"outcome":"budget"' "$rectilin" measure --json -o random --seconds 0.05 shape:box
expect 2 'seconds' "$rectilin" measure --seconds -1 shape:box

# Numbers that are none, or too large, or of the wrong sign: one line.
for wrong in '--threads 0' '--threads 2000000000' '--gap -1' '--gap nan' '--seconds nan' '--budget -1' '--seed -1'; do
  expect 2 'is not a' "$rectilin" measure $wrong shape:box
  [ "$(wc -l <err)" -eq 1 ] || fail "one line for $wrong"
done
expect 0 '"evaluations":10000' "$rectilin" measure --json -o 'ga?generations=0' shape:box

# Progress within a mesh, on a terminal only, and gone at the end.
hard=(measure --seconds 3 'shape:sphere?kind=even&faces=100000')
expect 0 '^shape:sphere' "$rectilin" "${hard[@]}"
[ -s err ] && fail 'progress without a terminal'
script -qec "$(printf '%q ' "$rectilin" "${hard[@]}")" terminal >/dev/null </dev/null || fail 'measure on a terminal'
grep -qE '\[0/1\] [^[]* evaluations, [0-9]+ boxes bounded, R >= [0-9.]+, gap ' terminal || fail 'no progress on a terminal'
tail -n 2 terminal | grep -q $'\r\e\[K$' || fail 'progress is left on the terminal'

# A bad file costs its own row.
"$rectilin" convert shape:pyramid good.off || fail 'the command itself'
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >bad.off
expect 1 'bad\.off:.*6' "$rectilin" measure good.off bad.off shape:box
[ "$(grep -c '^good.off\|^shape:box' out)" -eq 2 ] || fail 'rows of the good files'
expect 1 '"name":"bad.off","error"' "$rectilin" measure --json good.off bad.off
[ "$(wc -l <out)" -eq 2 ] || fail 'one JSON line per file'

# A list on standard input; folders; conversions that keep the measure.
printf 'good.off\nshape:box\n' | "$rectilin" measure --json - >out || fail 'the command itself'
[ "$(wc -l <out)" -eq 2 ] || fail 'list on standard input'
mkdir -p folder/below
for format in off obj ply stl; do "$rectilin" convert shape:pyramid folder/below/p.$format; done
expect 0 'folder/below/p.stl' "$rectilin" measure --json folder
[ "$(grep -o '"rectilinearity":[0-9.]*' out | cut -c1-27 | sort -u | wc -l)" -eq 1 ] ||
  fail 'formats agree'
mkdir empty
ln -s loop.off folder/loop.off
expect 1 'empty: no mesh file' "$rectilin" measure empty folder
[ "$(wc -l <out)" -eq 5 ] || fail 'files beside an empty folder and a link to nowhere'
printf 'folder/below/p.off\nno\xff.off\n' | "$rectilin" measure --json - >out 2>err
[ $? -eq 1 ] && [ "$(wc -l <out)" -eq 2 ] || fail 'a name that is not UTF-8 costs its own row'

# What cannot be written is an error, and nothing half written stays.
expect 1 'unwritable' "$rectilin" convert shape:box unwritable/box.off
expect 1 'box.txt' "$rectilin" convert shape:box box.txt
(ulimit -f 1; trap '' XFSZ; "$rectilin" convert 'shape:blob?faces=2000' half.obj 2>err)
[ $? -eq 1 ] && grep -q 'half.obj: cannot be written' err && [ -z "$(ls half* 2>/dev/null)" ] || fail 'half a mesh'
if [ -e /dev/full ]; then
  for words in 'measure shape:box' 'measure --json shape:box' optimizers 'validate --list' --help; do
    "$rectilin" $words >/dev/full 2>err
    [ $? -eq 1 ] && grep -q 'standard output: cannot be written' err || fail "$words on a full disk"
  done
fi

# Same seed, same bits, for any number of threads; another seed, another run.
run() { "$rectilin" measure --json -o 'ga?generations=20' "$@" 'shape:blob?faces=5000' | grep -o '"digest":"[0-9a-f]*"'; }
one=$(run --threads 1)
[ "$one" = "$(run --threads 2)" ] && [ "$one" = "$(run --threads 8)" ] && [ "$one" != "$(run --seed 2)" ] ||
  fail 'digests'

# A proof is accepted for its mesh, and refused when it is changed or about another one.
expect 0 'good.off' "$rectilin" measure --proof proof.json good.off
expect 0 'accepted: R is between 0\.42705' "$rectilin" verify proof.json good.off
expect 1 'refused: .*another mesh' "$rectilin" verify proof.json shape:box
sed 's/"lower":1\.236/"lower":1.237/' proof.json >changed.json
expect 1 'refused: .*bound' "$rectilin" verify changed.json good.off
expect 1 'missing.json' "$rectilin" verify missing.json good.off
expect 2 'one mesh at a time' "$rectilin" measure --proof proof.json good.off shape:box
expect 1 'unwritable' "$rectilin" measure --proof unwritable/p.json good.off
grep -q '^good.off' out || fail 'the row of a proof that cannot be written'
cp good.off kept.off
expect 2 'would replace a mesh' "$rectilin" measure --proof good.off good.off
expect 2 'would replace a mesh' "$rectilin" measure --proof folder/below/p.stl shape:box
cmp -s good.off kept.off || fail 'the mesh is as it was'
expect 1 'budget ends' "$rectilin" measure --budget 1 good.off

# Point clouds with normals: three directions at right angles, with weights and without.
cloud() { printf 'ply\nformat ascii 1.0\nelement vertex %s\n' "$1"; shift; printf 'property float %s\n' "$@"; echo end_header; }
{ cloud 3 x y z nx ny nz; printf '0 0 0 %s\n' '1 0 0' '0 2 0' '0 0 -3'; } >cloud.ply
expect 0 'cloud.ply +3 +3 +3 +1\.0000000000' "$rectilin" measure --normals cloud.ply
{ cloud 2 nx ny nz weight; printf '%s\n' '1 0 0 3' '0.6 0.8 0 4'; } >weights.ply
expect 0 'weights.ply +2 +2 +7 ' "$rectilin" measure --normals weights.ply
{ cloud 2 nx ny nz weight; printf '%s\n' '1 0 0 3' '0.6 0.8 0 -4'; } >negative.ply
expect 1 'negative.ply:line 10: a weight that is negative' "$rectilin" measure --normals negative.ply
{ cloud 2 nx ny nz; printf '%s\n' '0 0 0' 'nan 0 0'; } >none.ply
expect 1 'none.ply: no point has a normal' "$rectilin" measure --normals none.ply
{ cloud 5 nx ny nz; printf '%s\n' '1 0 0'; } >short.ply
expect 1 'short.ply:.*the file ends' "$rectilin" measure --normals short.ply
{ cloud 2 x y z; printf '%s\n' '1 0 0' '0 1 0'; } >bare.ply
expect 1 'bare.ply:line 3: the vertices have no normals' "$rectilin" measure --normals bare.ply
expect 1 'good.off: point clouds with normals are read from PLY' "$rectilin" measure --normals good.off
expect 2 'does not go with --proof' "$rectilin" measure --normals --proof p.json cloud.ply

finish command
