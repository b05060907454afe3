#!/usr/bin/env bash
# rectilin serve from outside: its API, hostile requests and files.  Usage: serve.sh RECTILIN
here=$(cd "$(dirname "$0")" && pwd)
command -v curl >/dev/null || { echo "skipped: there is no curl"; exit 77; }
. "$here/expect.sh"
. "$here/serving.sh"

# ask STATUS PATTERN PATH CURL-OPTION...: the status, and a pattern in the answer.
ask() {
  local status=$1 pattern=$2 path=$3 got; shift 3
  got=$(curl -sS --max-time 60 --path-as-is -o answer -w '%{http_code}' "$@" "$url$path" 2>err); : >out
  [ "$got" = "$status" ] && LC_ALL=C grep -qaE -- "$pattern" answer || { fail "GET $path $* ($got, expected $status and /$pattern/)"; head -c 300 answer; }
}
send() { ask "$1" "$2" "api/search?count=20&file=$3" --data-binary "@$4" -H 'Content-Type: application/octet-stream'; }

start shapes shapes.db
grep -q 'shapes.db: 12 shapes at http://127.0.0.1:' shapes.out || fail "the line that says where the page is"

# The API says what the command says.
ask 200 '"shapes":12,"failed":0' api/collection
ask 200 '"total":4,.*torus1.stl.*torus4.stl' 'api/shapes?name=TORUS'
ask 200 '"total":12,"from":10,"shapes":\[\{[^]]*stl"[^]]*stl"[^]]*\]' 'api/shapes?from=10&count=5'
ask 200 '"total":0,"from":0,"shapes":\[\]' 'api/shapes?name=nothing'
id=$(curl -s "${url}api/shapes?name=torus2" | grep -o '"id":"[0-9]*"' | grep -o '[0-9]*')
"$rectilin" search shapes.db --like meshes/torus2.stl -n 7 --json >by_command
ask 200 torus "api/matches?id=$id&count=7"; cmp -s answer by_command || fail "matches are those of rectilin search"
"$rectilin" search shapes.db --like meshes/torus2.stl -n 7 --json --collection >by_command
ask 200 torus "api/matches?id=$id&count=7&collection=1"; cmp -s answer by_command || fail "matches through the collection"
ask 200 '^meshes/torus2.stl,1,[0-9.]+,meshes/torus1.stl' "api/matches?id=$id&format=csv&name=torus"
[ "$(wc -l <answer)" -eq 4 ] || fail "a line for each match, and one with the columns"
send 200 '"name":"another.ply"' another.ply another.ply; cp answer sent
"$rectilin" search shapes.db another.ply --json >by_command
python3 - sent by_command <<'P' || fail "an uploaded file is found as by the command"
import json, sys
sent, command = [json.load(open(name)) for name in sys.argv[1:]]
assert [(r["name"], r["distance"], r["rank"]) for r in sent["results"]] == \
       [(r["name"], r["distance"], r["rank"]) for r in command["results"]]
assert sent["query"]["faces"] == 4096, sent["query"]
P
upload=$(grep -o '"id":"u[0-9a-f]*"' sent | grep -o 'u[0-9a-f]*' | tail -n 1)
ask 200 '^.PNG' "api/picture?id=$id"; ask 200 '^.PNG' "api/picture?id=$upload"
python3 - "$url" "$id" "$upload" <<'P' || fail "meshes, and how one is turned onto another"
import json, struct, sys, urllib.request
url, member, upload = sys.argv[1:]
def mesh(id):
    data = urllib.request.urlopen(f"{url}api/mesh?id={id}").read()
    magic, vertices, original, triangles = struct.unpack("<4sIII", data[:16])
    assert magic == b"RMSH" and original == triangles == 4096 and len(data) == 16 + 12 * triangles + 6 * vertices
    indices = struct.unpack(f"<{3 * triangles}I", data[16:16 + 12 * triangles])
    assert max(indices) == vertices - 1
    points = struct.unpack(f"<{3 * vertices}h", data[16 + 12 * triangles:])
    return [[x / 32767 for x in points[i:i + 3]] for i in range(0, len(points), 3)]
one, other = mesh(member), mesh(upload)
farthest = max(sum(x * x for x in p) for p in one)
assert abs(farthest - 1) < 1e-3, farthest
turn = json.load(urllib.request.urlopen(f"{url}api/turn?query={member}&result={upload}"))
r = [turn["rotation"][i:i + 3] for i in (0, 3, 6)]
for i in range(3):
    for j in range(3):
        assert abs(sum(r[i][k] * r[j][k] for k in range(3)) - (i == j)) < 1e-6, "a rotation"
assert turn["distance"] < 0.01, turn["distance"]
def near(p):
    return min(sum((a - b) ** 2 for a, b in zip(p, q)) for q in one) ** 0.5
turned = [[sum(row[k] * p[k] for k in range(3)) for row in r] for p in other[::97]]
assert max(map(near, turned)) < 0.15, "the copy lies on the original"
P

# Nothing but members of the database, and only as they were indexed.
for path in ../../etc/passwd %2e%2e/%2e%2e/etc/passwd ..%2f..%2fetc/passwd three/../../../CMakeLists.txt \
  //etc/passwd index.html%00.js shapes.db meshes/box1.off; do ask 404 'nothing of that name' "$path"; done
for bad in ../../etc/passwd /etc/passwd shape:box meshes/box1.off 0 -1 99999999999999999999 1.0 %00 u u00; do
  for what in mesh picture search matches; do ask 404 '^\{"error":' "api/$what?id=$bad"; done
done
ask 400 "'id' is missing" api/mesh
ask 400 'count is not a whole number from 1' "api/search?id=$id&count=0"
ask 400 'count is not a whole number from 1' "api/search?id=$id&count=1e9"
ask 400 'format is json or csv' "api/matches?id=$id&format=../x"
cp -r meshes kept
echo '# another' >>meshes/box4.off
box=$(curl -s "${url}api/shapes?name=box4" | grep -o '"id":"[0-9]*"' | grep -o '[0-9]*')
ask 422 '^\{"error":"meshes/box4.off: changed since it was indexed' "api/mesh?id=$box"
rm meshes/box3.off; ln -s /etc/passwd meshes/box3.off
box=$(curl -s "${url}api/shapes?name=box3" | grep -o '"id":"[0-9]*"' | grep -o '[0-9]*')
ask 422 'meshes/box3.off: changed since it was indexed' "api/mesh?id=$box"
rm meshes/box3.off; ask 422 '^\{"error":"meshes/box3.off: ' "api/picture?id=$box"
ask 200 '"rank":1' "api/search?id=$box"
cp kept/box?.off meshes

# Other sites, other methods.
ask 403 'does not go by that name' '' -H 'Host: evil.example'
ask 403 'does not go by that name' "api/shapes" -H 'Host: 127.0.0.1.evil.example'
ask 403 'another site' "api/shapes" -H 'Sec-Fetch-Site: cross-site'
ask 403 'another site' 'api/search?file=a.ply' --data-binary @another.ply -H 'Origin: http://evil.example'
ask 403 'another site' 'api/search?file=a.ply' --data-binary @another.ply -H 'Origin: null'
ask 200 torus 'api/search?file=a.ply' --data-binary @another.ply -H "Origin: ${url%/}"
ask 200 '"shapes":12' api/collection -H 'Host: localhost'
ask 405 'only GET' '' -X DELETE
ask 405 'only GET' api/shapes --data x
ask 400 'a body where none belongs' api/shapes -X GET --data x
curl -sS -D - -o /dev/null "$url" | grep -qi "^content-security-policy: default-src 'none'" || fail "a strict policy"

# Files that are too large, empty, or no meshes: one line each, that names the file as its owner does.
ask 413 'larger than 256 MiB' 'api/search?file=a.stl' -X POST -H 'Content-Length: 999999999999'
ask 411 'Content-Length' 'api/search?file=a.stl' --data-binary @another.ply -H 'Transfer-Encoding: chunked'
: >empty.off; send 400 'the file is empty' empty.off empty.off
ask 400 "'file' is missing" api/search --data-binary @another.ply
send 422 '^\{"error":"broken.off:line 6: [^"]*"\}$' broken.off broken.off
send 422 '^\{"error":"passwd: [^"]*"\}$' ../../etc/passwd /etc/passwd
send 422 '^\{"error":"x[^"]*"\}$' 'x%0d%0aSet-Cookie:%20a=b%00.off' broken.off
head -c 100000 another.ply >cut.ply; send 422 '"cut.ply' cut.ply cut.ply
printf 'ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int i\nend_header\n' >huge.ply
send 422 '"huge.ply' huge.ply huge.ply
head -c 300000000 /dev/zero | gzip >zeros.stl.gz; send 422 '"zeros.stl' zeros.stl.gz zeros.stl.gz
mkdir hostile
python3 - "$here/../fuzz/corpus" hostile <<'P' || fail "hostile files"
import pathlib, random, sys
corpus, out = map(pathlib.Path, sys.argv[1:])
random.seed(7)
seeds = sorted(f for folder in ("mesh", "gltf", "three_mf") for f in (corpus / folder).iterdir())
for k, seed in enumerate(seeds * 2):
    data = bytearray(seed.read_bytes())
    extension = seed.parent.name
    if extension == "mesh":  # the first byte of these picks the format
        extension = ("off", "obj", "ply", "stl")[data[0] % 4]
        del data[0]
    if k >= len(seeds):
        for _ in range(8):
            data[random.randrange(len(data))] = random.randrange(256)
        del data[random.randrange(len(data) // 2, len(data)):]
    name = {"gltf": "gltf" if data[:1] == b"{" else "glb", "three_mf": "3mf"}.get(extension, extension)
    (out / f"f{k}.{name}").write_bytes(data or b"x")
P
hostile() {
  local code answer; answer=$(mktemp answer.XXXX)
  code=$(curl -sS --max-time 60 -o "$answer" -w '%{http_code}' --data-binary "@$2" "$1api/search?file=$(basename "$2")")
  [ "$code" = 200 ] || { [ "$code" = 422 ] && grep -q "^{\"error\":\"$(basename "$2")" "$answer"; } || { echo "$2: $code"; cat "$answer"; }
}
export -f hostile
ls hostile/* | TMPDIR=$work xargs -P 8 -I{} bash -c 'hostile "$@"' _ "$url" {} >told 2>&1
[ ! -s told ] || { fail "a hostile file is read or is one error"; cat told; }
[ "$(ls hostile | wc -l)" -ge 40 ] || fail "forty hostile files"
[ -z "$(ls -A "$TMPDIR")" ] || fail "uploads are left behind: $(ls "$TMPDIR")"

# A thousand clients that are wrong in every way, while one that is right is served.
python3 "$here/serve_abuse.py" "$(echo "$url" | grep -o ':[0-9]*/' | tr -d ':/')" >abuse 2>&1 &
abuse=$!
ask 200 torus "api/search?id=$id"
wait $abuse || { fail "a thousand malformed requests"; cat abuse; }
ask 200 torus "api/search?id=$id"
ask 200 '"shapes":12' api/collection

# Ports, bad databases.
port=$(echo "$url" | grep -o ':[0-9]*/' | tr -d ':/')
expect 1 "^rectilin: 127.0.0.1:$port: the port is in use" "$rectilin" serve shapes.db --port "$port"
expect 1 'not an address of numbers' "$rectilin" serve shapes.db --address example.com
expect 1 'nowhere.db' "$rectilin" serve nowhere.db
expect 1 'another.ply: ' "$rectilin" serve another.ply --port 0
head -c 20000 shapes.db >cut.db; expect 1 'cut.db: ' "$rectilin" serve cut.db --port 0
[ "$(cat out err | wc -l)" -eq 1 ] || fail "one line about a cut database"
cp shapes.db other.db
python3 -c "import sqlite3; d = sqlite3.connect('other.db'); d.execute(\"UPDATE facts SET value = 'x' WHERE key <> 'descriptor'\"); d.commit()"
expect 1 'other.db: ' "$rectilin" serve other.db --port 0
[ "$(cat out err | wc -l)" -eq 1 ] || fail "one line about a database of another build"
[ -e nowhere.db ] && fail "a database was made by serving"
shapes_pid=$pid

# An empty database, an installed program without three.js.
"$rectilin" index none -o empty.db -d r >/dev/null 2>&1
mkdir -p prefix/bin prefix/share/rectilin
cp "$rectilin" prefix/bin/rectilin; cp -rL "$(dirname "$rectilin")/../serve/page" prefix/share/rectilin/page
rm -rf prefix/share/rectilin/page/three
installed=$rectilin; rectilin=$work/prefix/bin/rectilin
start empty empty.db
rectilin=$installed
grep -q 'without 3D: three.js was not there' empty.out || fail "what is missing without three.js"
ask 200 '"shapes":0,.*"viewer":false' api/collection
ask 200 '"total":0' api/shapes
send 200 '"results":\[\]' another.ply another.ply

# Ctrl-C ends it, at once and cleanly.
kill -INT "$shapes_pid"; wait "$shapes_pid" || fail "Ctrl-C: status $?"
[ ! -s shapes.err ] || { fail "the server complained"; cat shapes.err; }
[ -z "$(ls -A "$TMPDIR")" ] || fail "uploads are left behind: $(ls "$TMPDIR")"

finish serve
