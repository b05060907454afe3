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

# Poses: shards, merged and exported, are those of a run without a store.
expect 0 '9 done .1 of them equal.*, 1 failed' "$rectilin" pose m -o pose.db
for i in 0 1 2; do expect 0 'done' "$rectilin" pose m -o pose$i.db --shard $i/3 --threads 1; done
expect 0 '10 meshes, 10 added, 0 conflicts' "$rectilin" merge pose0.db pose1.db pose2.db -o posed.db
expect 0 '10 meshes, 0 added, 0 conflicts' "$rectilin" merge pose0.db pose1.db pose2.db -o posed.db
for store in pose posed; do "$rectilin" export $store.db >out || fail "export $store"; done
for store in pose posed; do sed -E 's/,"seconds":[^,]*,"version"/,"version"/' $store.jsonl >$store.bits; done
cmp pose.bits posed.bits || fail 'shards of poses and the whole give the same bits'
head -n 1 pose.csv | grep -q 'chosen,uniqueness,scale,confidence' || fail 'columns of poses'
"$rectilin" pose --json m 2>/dev/null | sed -n 's/.*"name":"\([^"]*\)".*"rotation":\(\[\[[^{]*\]\]\),"centre".*/\1 \2/p' | sort >plain
sed -n 's/.*"name":"\([^"]*\)".*"rotation":\(\[\[[^{]*\]\]\),"centre".*/\1 \2/p' pose.jsonl | sort >stored
[ "$(wc -l <plain)" -eq 9 ] && cmp plain stored || fail 'the same poses'
expect 2 "of 'measure', not of 'pose'" "$rectilin" pose m -o all.db
expect 2 "of 'pose', not of 'measure'" "$rectilin" measure m -o pose.db
expect 2 '"axes":"free"' "$rectilin" pose m -o pose.db --axes ordered
expect 2 'another task' "$rectilin" merge pose0.db part0.db -o mixed.db
expect 2 'need a store' "$rectilin" pose m --shard 0/2
expect 2 'cannot be used with a store' "$rectilin" pose m -o pose.db --write posed
expect 2 'no pose method' "$rectilin" pose m -o new.db --method none
[ ! -e new.db ] || fail 'no store of a wrong command'
expect 0 '1 limited' "$rectilin" pose 'shape:blob?faces=1000000' shape:box -o pose-limits.db --memory 20M

# Databases of shapes: shards, in worker processes, make the whole; limits; other kinds of files.
d='d2?samples=1000+r'
expect 1 '8 added, .* 1 copies, .* 1 failed' "$rectilin" index m -o shapes.db -d "$d"
for i in 0 1 2; do "$rectilin" index m -o shapes$i.db -d "$d" --shard $i/3 --threads 1 >/dev/null 2>&1; done
expect 0 '10 meshes, 10 added, 0 conflicts' "$rectilin" merge shapes0.db shapes1.db shapes2.db -o merged-shapes.db
expect 0 '10 meshes, 0 added, 0 conflicts' "$rectilin" merge shapes2.db shapes0.db shapes1.db -o merged-shapes.db
"$rectilin" search shapes.db --like m/meshes6.off --like m/again.off -n 9 --json >whole &&
  "$rectilin" search merged-shapes.db --like m/meshes6.off --like m/again.off -n 9 --json >parts
[ "$(wc -l <whole)" -eq 2 ] && cmp whole parts || fail 'the same results in a merged database'
expect 0 'merged-shapes.db +- .* 9 +1 +0 +0' "$rectilin" corpus status merged-shapes.db
expect 0 'shapes1.db +1/3' "$rectilin" corpus status shapes1.db
expect 1 'all.db: not a database of shapes' "$rectilin" index m -o all.db -d "$d"
expect 1 'shapes.db: not a store' "$rectilin" measure m -o shapes.db
expect 1 'shapes.db: not a store' "$rectilin" export shapes.db
expect 2 'cannot be merged' "$rectilin" merge shapes0.db all.db -o mixed.db
[ ! -e mixed.db ] || fail 'nothing of a merge that was refused'
"$rectilin" index m -o other-shapes.db -d r >/dev/null 2>&1
expect 2 "holds signatures of 'r'" "$rectilin" merge shapes0.db other-shapes.db -o mixed.db
expect 1 '0 added.*10 in other databases|0 added.*9 in other databases' "$rectilin" index m -o rest.db -d "$d" --done shapes.db --retry
expect 1 'more than 20971520 bytes of memory' "$rectilin" index 'shape:blob?faces=1000000' shape:box -o small.db -d r --memory 20M
expect 1 '1 unchanged, 1 failed|2 unchanged, 1 failed' "$rectilin" index 'shape:blob?faces=1000000' shape:box -o small.db -d r
expect 0 '1 changed' "$rectilin" index 'shape:blob?faces=1000000' shape:box -o small.db -d r --retry

# Comparisons: shards, merged, give the page of a comparison without a store.
c=("$rectilin" compare shape:box shape:pyramid missing.off -k 4 -o 'ga,random,tight=grid?keep=1@zone' -b 300)
"${c[@]}" -O whole-page >/dev/null 2>&1
for i in 0 1 2; do "${c[@]}" -o runs$i.db --shard $i/3 --threads 2 >/dev/null 2>&1; done
expect 0 ' 0 conflicts' "$rectilin" merge runs0.db runs1.db runs2.db -o runs.db
expect 1 'parts-page/index.html' "$rectilin" compare --from runs.db -O parts-page
[ "$(grep -c 'missing.off' err)" -eq 1 ] || fail 'one line for the mesh that is missing'
for page in whole-page parts-page; do
  for file in runs meshes; do
    sed -E 's/"(cpu_)?seconds":(\[[^]]*\]|[^,]*)//g; s/"threads":[0-9]*//' $page/$file.jsonl | sort >$page/$file.bits
  done
done
[ "$(wc -l <whole-page/runs.bits)" -eq 24 ] && cmp whole-page/runs.bits parts-page/runs.bits || fail 'the same runs'
cmp whole-page/meshes.bits parts-page/meshes.bits || fail 'the same bounds'
cut -d, -f1-10 whole-page/runs.csv >a; cut -d, -f1-10 parts-page/runs.csv >b; cmp a b || fail 'the same table'
expect 1 'rows of the plan are not in the store yet' "$rectilin" compare --from runs1.db -O part-page
expect 2 'of .compare. with .*"budget":300.*"budget":301' "${c[@]::9}" -b 301 -o runs0.db
expect 2 "of 'measure', not of 'compare'" "${c[@]}" -o all.db
expect 2 "not of 'compare'" "$rectilin" compare --from all.db -O no-page
expect 2 'none can be given' "$rectilin" compare shape:box --from runs.db -O no-page
expect 2 'no source' "$rectilin" compare
expect 2 'need a store' "$rectilin" compare shape:box -o random --shard 0/2
expect 2 'holds runs that the store does not have' "$rectilin" compare --from runs1.db -O whole-page
expect 1 'not a store' "$rectilin" compare --from shapes.db -O no-page
[ ! -e no-page ] || fail 'no folder of a wrong command'

# Two writers; stores of another version; a disk that is full.
for i in $(seq 200); do echo "shape:blob?faces=5000&seed=$i"; done >many.txt
for kind in measure pose 'index -d r'; do
  begin "$rectilin" ${kind%% *} many.txt -o busy.db ${kind#"${kind%% *}"} --threads 1
  for _ in $(seq 500); do [ -s busy.db ] && break; sleep 0.01; done
  kill -STOP $pid || fail "$kind: the first writer was too quick to be stopped"  # so that it is at work, however quick
  "$rectilin" ${kind%% *} many.txt -o busy.db ${kind#"${kind%% *}"} >out2 2>err2
  [ $? -eq 1 ] && grep -q 'another program is writing to it' err2 || fail "one writer at a time: $kind"
  kill -KILL $pid; wait $pid 2>/dev/null; rm -f busy.db*
done
if command -v python3 >/dev/null; then
  for store in pose shapes runs; do
    cp $store.db aged.db
    python3 -c "import sqlite3; s = sqlite3.connect('aged.db'); s.execute('PRAGMA user_version = 99'); s.commit()" || fail python3
    expect 1 'aged.db: .* of another version of the program' "$rectilin" corpus status aged.db
  done
fi
if [ "$(id -u)" -eq 0 ] && mkdir full && mount -t tmpfs -o size=128k tmpfs full 2>/dev/null; then
  for kind in measure pose 'compare -k 50 -b 50' 'index -d r'; do
    [ "$kind" != 'index -d r' ] || mount -o remount,size=48k full
    expect 1 'full/a.db: .*full' timeout 60 "$rectilin" ${kind%% *} many.txt -o full/a.db ${kind#"${kind%% *}"}
    rm -f full/*
  done
  umount full
fi

finish corpus
