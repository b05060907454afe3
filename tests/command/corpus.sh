#!/usr/bin/env bash
# Stores from outside: shards, limits, merge, export, status.  Usage: corpus.sh RECTILIN
. "$(dirname "$0")/expect.sh"

for i in 3 4 5 6 7 8 9 10; do "$rectilin" convert "shape:prism?sides=$i" "meshes$i.off" && mkdir -p m && mv "meshes$i.off" m/; done
cp m/meshes5.off m/again.off
printf 'OFF\nrubbish\n' >m/bad.off

expect 0 'all.db: 9 done \(1 of them equal to others\), 1 failed, 0 limited, 0 were there' "$rectilin" measure m -o all.db
expect 0 'all.db: 0 done, 0 failed, 0 limited, 10 were there' "$rectilin" measure m --out all.db --threads 1
expect 0 '1 failed.* 9 were there' "$rectilin" measure m -O all.db --retry
mkdir looped && "$rectilin" convert shape:box looped/a.off && ln -s . looped/loop || fail 'a folder in itself'
expect 1 'looped/loop: .*leads back' "$rectilin" measure looped -o looped.db
expect 2 "the store holds results of 'measure' with .*\"seed\":1" "$rectilin" measure m -o all.db --seed 2
expect 2 'need a store' "$rectilin" measure m --shard 0/2
expect 2 'more than one optimizer' "$rectilin" measure m -o grid -o ga
expect 2 'more than one store' "$rectilin" measure m -o a.db -o b.db
expect 2 "shard '2/2'" "$rectilin" measure m -o a.db --shard 2/2
expect 0 '9 done' "$rectilin" measure m -o grid -o grid.db
expect 1 'cannot be written' "$rectilin" measure m -o nowhere/a.db
expect 2 'cannot be used with a store' "$rectilin" measure m -o a.db --json

# Two shards make the whole, and merging twice changes nothing.
for i in 0 1; do expect 0 'done' "$rectilin" measure m -o part$i.db --shard $i/2; done
expect 0 '10 meshes, 10 added, 0 conflicts' "$rectilin" merge part0.db part1.db -o merged.db
expect 0 '10 meshes, 0 added, 0 conflicts' "$rectilin" merge part1.db part0.db -o merged.db
expect 2 'another task or other settings' "$rectilin" merge part0.db grid.db -o mixed.db
expect 1 'no such file' "$rectilin" merge part0.db missing.db -o mixed.db
expect 1 'not a store|not a database' "$rectilin" corpus status m/bad.off
for store in all merged; do "$rectilin" export $store.db >out || fail "export $store"; done
for store in all merged; do sed -E 's/,"seconds":[^,]*,"version"/,"version"/' $store.jsonl >$store.bits; done
cmp all.bits merged.bits || fail 'shards and the whole give the same bits'
[ "$(wc -l <all.csv)" -eq 11 ] || fail 'a row for each mesh, and a title'
expect 0 'merged.db +- .* 9 +1 +0 +0' "$rectilin" corpus status merged.db
expect 0 'part0.db +0/2' "$rectilin" corpus status part0.db part1.db

# The numbers are those of a run without a store.
"$rectilin" measure --json m 2>/dev/null | sed -n 's/.*"name":"\([^"]*\)".*"rectilinearity":\([0-9.e-]*\),.*/\1 \2/p' | sort >plain
sed -n 's/.*"name":"\([^"]*\)".*"rectilinearity":\([0-9.e-]*\),.*/\1 \2/p' all.jsonl | sort >stored
[ "$(wc -l <plain)" -eq 9 ] && cmp plain stored || fail 'the same R'

# A result that differs is a conflict.
if command -v python3 >/dev/null; then
  cp part0.db other.db
  python3 - <<'END' || fail 'python3'
import sqlite3
store = sqlite3.connect('other.db')
store.execute("UPDATE meshes SET result = '{}' WHERE name = (SELECT min(name) FROM meshes WHERE status = 3)")
store.commit()
END
  expect 1 'another result for the same mesh' "$rectilin" merge other.db -o merged.db
  if python3 -c 'import numpy' 2>/dev/null; then
    python3 - <<'END' || fail 'the array'
import csv, numpy
table = numpy.load('all.npy')
rows = list(csv.DictReader(open('all.csv')))
assert len(table) == len(rows) == 10
for a, b in zip(table, rows):
    assert a['name'].decode() == b['name']
    assert (b['rectilinearity'] == '' and numpy.isnan(a['rectilinearity'])) or a['rectilinearity'] == float(b['rectilinearity'])
    if b['status'] == 'done':
        assert abs(numpy.linalg.det(a['rotation']) - 1) < 1e-9
END
  fi
fi

# Limits: a hard mesh costs its row.
expect 0 '1 limited' "$rectilin" measure 'shape:blob?faces=1000000' shape:box -o limits.db --memory 20M
"$rectilin" export limits.db -o limits.csv >/dev/null
grep -q 'more than 20971520 bytes of memory' limits.csv || fail 'the reason of the limit'
expect 0 '0 done, .* 2 were there' "$rectilin" measure 'shape:blob?faces=1000000' shape:box -o limits.db
expect 0 '1 done, .* 1 were there' "$rectilin" measure 'shape:blob?faces=1000000' shape:box -o limits.db --retry

finish corpus
