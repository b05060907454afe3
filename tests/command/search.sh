#!/usr/bin/env bash
# rectilin index and search from outside: databases, resuming, results, bad input.  Usage: search.sh RECTILIN
. "$(dirname "$0")/expect.sh"

expect 0 'kill|goes|Database' "$rectilin" index --help
mkdir -p meshes/more
for i in 1 2 3 4; do
  "$rectilin" convert "shape:box?x=2&y=1.$i" meshes/box$i.off
  "$rectilin" convert "shape:torus?minor=0.3$i" meshes/torus$i.stl
  "$rectilin" convert "shape:stairs?steps=$((i + 2))" meshes/more/stairs$i.obj
done
d='gsmd?views=6+0.5*r'
expect 0 'shapes.db: 12 added, 0 changed' "$rectilin" index meshes -o shapes.db -d "$d"
expect 0 '0 added, .* 12 unchanged, 0 failed' "$rectilin" index meshes -o shapes.db -d "$d"
# A file is one shape, however often and by whatever path it is named.
expect 0 'again.db: 12 added, 0 changed, 0 moved, 0 copies' "$rectilin" index meshes ./meshes/more "$PWD/meshes/box1.off" -o again.db -d r

# A member finds its like first, a mesh from outside finds itself, whatever its file and position.
expect 0 'torus' "$rectilin" search shapes.db --like meshes/torus2.stl -n 3
[ "$(grep -c torus out)" -eq 4 ] || fail "three tori are nearest to a torus"
"$rectilin" convert meshes/torus2.stl turned.ply
expect 0 '"query":"turned.ply"' "$rectilin" search shapes.db turned.ply meshes/box1.off -n 20 --json
[ "$(wc -l <out)" -eq 2 ] || fail "a line for each query"
python3 - out <<'P' || fail "the JSON of search"
import json, sys
first, second = [json.loads(line) for line in open(sys.argv[1])]
assert set(first) == {"query", "results"}, first
assert len(first["results"]) == 12
assert first["results"][0]["name"] == "meshes/torus2.stl"
assert second["results"][0] == {"name": "meshes/box1.off", "distance": 0, "rank": 1}, second["results"][0]
for found in first, second:
    distances = [r["distance"] for r in found["results"]]
    assert distances == sorted(distances)
    assert [r["rank"] for r in found["results"]] == list(range(1, 13))
    assert all(set(r) == {"name", "distance", "rank"} for r in found["results"])
P
cp out all; expect 0 query "$rectilin" search shapes.db turned.ply meshes/box1.off --json -t 1
cmp -s out all || fail "the same for one thread"
expect 0 stairs "$rectilin" search shapes.db turned.ply --name '*stairs*'
if grep -q 'box\|torus' out; then fail "a filter by name"; fi
expect 0 box "$rectilin" search shapes.db turned.ply --min-r 0.99 --max-size 3
if grep -q torus out; then fail "a filter by R"; fi
expect 0 turned "$rectilin" search shapes.db turned.ply -n 4 --page found.html
[ "$(grep -o 'data:image/png' found.html | wc -l)" -eq 5 ] || fail "five pictures on the page"

expect 0 torus "$rectilin" search shapes.db --like meshes/torus2.stl -n 3 --collection
[ "$(grep -c torus out)" -eq 4 ] || fail "three tori are nearest to a torus through the collection"

# Copies in other formats, and the same bytes again.
cp -r meshes copies; "$rectilin" convert meshes/torus2.stl copies/other.ply
expect 0 '13 added' "$rectilin" index copies -o copies.db
# Tori whose tubes differ by a thirtieth are 0.006 radii apart: another shape by a narrower tolerance.
expect 0 '1 groups in 13 shapes' "$rectilin" duplicates copies.db --page groups.html -O pairs --tolerance 0.003
grep -q other.ply out || fail "the copy in another format is found"
grep -qE 'R 0\.[0-9]{6}\.\.0\.[0-9]{6} and' out || fail "intervals of R"
[ "$(grep -o 'data:image/png' groups.html | wc -l)" -eq 3 ] || fail "two pictures of the group and one of the pair"
[ "$(ls pairs)" = group1-1.png ] || fail "a picture of one surface laid on the other"
expect 0 '"placement":\[\[' "$rectilin" duplicates copies.db --json --tolerance 0.003
python3 - out <<'P' || fail "the JSON of duplicates"
import json, sys
group, = [json.loads(line) for line in open(sys.argv[1])]
pair, = group["evidence"]
assert pair["surface_distance"] < 1e-4 and pair["shared_vertices"] == 1 and not pair["mirrored"], pair
assert abs(pair["scale"] - 1) < 1e-4
low, high = pair["rectilinearity_first"]
assert low <= high <= low + 2e-6
# One file is the other in another format: its coordinates are taken to themselves, or to a symmetry of the torus.
rows = [row[:3] for row in pair["placement"]]
for i in range(3):
    for j in range(3):
        assert abs(sum(a * b for a, b in zip(rows[i], rows[j])) - (i == j)) < 1e-3, rows
P
expect 1 'Not a directory|File exists|not a directory' "$rectilin" duplicates copies.db -O copies/box1.off/pairs
cp copies/box1.off copies/again.off
expect 0 '1 copies' "$rectilin" index copies -o copies.db
expect 0 '"same_bytes":true' "$rectilin" duplicates copies.db --json --tolerance 0.003
[ "$(wc -l <out)" -eq 2 ] || fail "a line for each group"
rm copies/torus2.stl; expect 0 '1 removed' "$rectilin" index copies -o copies.db
mv copies/box2.off copies/moved.off; expect 0 '1 moved' "$rectilin" index copies -o copies.db

# Killed at any moment, the same command ends the same.
for wait in 0.05 0.2 0.5; do
  "$rectilin" index meshes -o killed.db -d "$d" >/dev/null 2>&1 & pid=$!
  sleep $wait; kill -9 $pid 2>/dev/null; wait $pid 2>/dev/null
done
expect 0 'unchanged' "$rectilin" index meshes -o killed.db -d "$d"
expect 0 query "$rectilin" search killed.db turned.ply meshes/box1.off --json
cmp -s out all || fail "the same results after kill -9"

# A file that may not grow, as on a full disk: one line, nothing damaged, and with room the same command goes on.
(trap '' XFSZ; ulimit -f 24; expect 1 'full.db: ' "$rectilin" index meshes -o full.db; exit $failures) ||
  fail "a full disk while indexing"
expect 0 ' 0 failed' "$rectilin" index meshes -o full.db
expect 0 torus2 "$rectilin" search full.db turned.ply
(trap '' XFSZ; ulimit -f 1; expect 1 'found-full.html: ' "$rectilin" search full.db turned.ply -n 3 --page found-full.html
 exit $failures) || fail "a full disk while writing a page"
[ -e found-full.html ] && fail "half of a page was left"

# While one program writes, another one is turned away, and then the first goes on.
begin "$rectilin" index meshes -o two.db
for i in $(seq 500); do [ -e two.db-lock ] && break; sleep 0.01; done
kill -STOP $pid || fail "the first writer was too quick to be stopped"
mkdir -p second
(cd second && expect 1 'two.db: another program is writing to it' "$rectilin" index ../meshes -o ../two.db
 exit $failures) || fail "the second writer"
kill -CONT $pid; wait $pid || fail "the first of two writers"
expect 0 '12 unchanged' "$rectilin" index meshes -o two.db

# The same at the moment when the first has made the file and not yet its tables; killed then, it left an empty file.
: >begun.db
(exec 9>begun.db-lock && flock 9 &&
 expect 1 'begun.db: another program is writing to it' "$rectilin" index meshes -o begun.db; exit $failures) ||
  fail "a file that another writer has begun"
expect 0 '12 added' "$rectilin" index meshes -o begun.db

# Another program's database.
python3 -c 'import sqlite3; c = sqlite3.connect("foreign.db"); c.execute("create table x (a)"); c.commit()'
cp foreign.db foreign.before
expect 1 'foreign.db: not a database of shapes' "$rectilin" search foreign.db turned.ply
expect 1 'foreign.db: not a database of shapes' "$rectilin" index meshes -o foreign.db
expect 1 'foreign.db: not a database of shapes' "$rectilin" duplicates foreign.db
cmp -s foreign.db foreign.before || fail "another program's database was changed"

# By a graph of neighbours: the same, and its file is beside the database.
"$rectilin" search shapes.db turned.ply -n 3 --json >exact.json 2>err || fail "an exact search"
expect 0 'distance' "$rectilin" search shapes.db turned.ply -n 3 --json --approximate
cmp -s out exact.json || fail "the approximate search of a few shapes is not the exact one"
[ -s shapes.db-graph ] || fail "no graph beside the database"
cp shapes.db-graph graph.before
expect 0 'distance' "$rectilin" search shapes.db turned.ply --approximate
cmp -s shapes.db-graph graph.before || fail "a graph changed that was complete"
head -c 50 graph.before >shapes.db-graph
expect 0 'shapes.db-graph: is damaged; the graph is built anew' "$rectilin" search shapes.db turned.ply --approximate
cmp -s shapes.db-graph graph.before || fail "a damaged graph was not replaced by the same"
echo "my notes" >shapes.db-graph
expect 1 'shapes.db-graph: is no graph of neighbours' "$rectilin" search shapes.db turned.ply --approximate
[ "$(cat shapes.db-graph)" = "my notes" ] || fail "somebody's file was replaced"
rm shapes.db-graph
"$rectilin" duplicates shapes.db >exact.txt 2>err
expect 0 'groups in' "$rectilin" duplicates shapes.db --approximate
cmp -s out exact.txt || fail "duplicates by a graph differ"

# Bad input.
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >meshes/bad.off
expect 1 'bad.off:line' "$rectilin" index meshes -o shapes.db -d "$d"
expect 1 'bad.off:line' "$rectilin" search shapes.db meshes/bad.off
expect 1 "no member 'meshes/bad.off' with a signature" "$rectilin" search shapes.db --like meshes/bad.off
expect 1 "no member 'nobody'" "$rectilin" search shapes.db --like nobody
expect 1 'nowhere.db' "$rectilin" search nowhere.db turned.ply
mkdir links && ln -s . links/loop && ln -s nowhere links/gone.off || fail links
expect 1 'loop: this link leads back' "$rectilin" index links -o links.db
expect 1 'gone.off: no such file' "$rectilin" index links -o links.db
[ -e nowhere.db ] && fail "a database was made by searching"
expect 1 'turned.ply: ' "$rectilin" search turned.ply turned.ply
expect 2 "holds signatures of" "$rectilin" index meshes -o shapes.db -d r
expect 2 "no descriptor 'gsmt'" "$rectilin" index meshes -o new.db -d gsmt
[ -e new.db ] && fail "a database of no descriptor was made"
expect 2 'nothing to search for' "$rectilin" search shapes.db
head -c 20000 shapes.db >cut.db
expect 1 'cut.db: ' "$rectilin" search cut.db turned.ply
expect 1 'cut.db: ' "$rectilin" index meshes -o cut.db -d "$d"

finish search
