#!/usr/bin/env bash
# Pictures and areas from outside: files, sheets, intervals, errors, exit statuses.  Usage: render.sh RECTILIN
. "$(dirname "$0")/expect.sh"

# One folder a mesh, one file a view, a sheet; a bad file costs its own row.
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >one.off
echo nonsense >bad.off
expect 1 'one\.off +1 +6 +pictures/one' "$rectilin" render one.off bad.off shape:box --views 6 --size 32 -O pictures
expect 0 '^6$' sh -c 'ls pictures/one/view-*.png | wc -l'
expect 0 '^6$' sh -c 'ls pictures/box/view-*.png | wc -l'
expect 0 'image/png;base64' cat pictures/box/sheet.svg
[ ! -e pictures/bad ] || fail 'pictures/bad is not written'
expect 1 'bad.off' "$rectilin" render bad.off -O none
[ ! -e none ] || fail 'none is not written'

# Two meshes of one name get two folders.
mkdir -p a b && cp one.off a/ && cp one.off b/One.off
expect 0 'twice/One_2' "$rectilin" render a b --views 6 --size 8 -O twice

# Sizes and bits, as the files have them: width, bits a value, grey.
header() { od -An -tu1 -j "$2" -N "$3" "$1" | tr -s ' '; }
expect 0 'deep' "$rectilin" render shape:box --views 6 --size 300 --bits 16 --depth -O deep
[ "$(header deep/box/view-0000.png 16 10)" = " 0 0 1 44 0 0 1 44 16 0" ] || fail "a 16-bit picture of 300 pixels"
expect 0 'flat' "$rectilin" render shape:box --views 6 --size 300 --silhouette -O flat
[ "$(header flat/box/view-0000.png 24 2)" = " 8 0" ] || fail "an 8-bit picture"
expect 0 'nice' "$rectilin" render shape:box --views 6 --size 64 --shaded --z-up -O nice
for threads in 1 4; do
  expect 0 'blob' "$rectilin" render 'shape:blob?seed=2' --views 18 --size 64 -t $threads -O threads$threads
done
diff -r threads1 threads4 || fail 'the same pictures for any number of threads'

expect 2 '6, 18, 66' "$rectilin" render one.off --views 20 -O wrong
expect 2 'pixels' "$rectilin" render one.off --size 0 -O wrong
expect 2 'pixels' "$rectilin" render one.off --size 100000 -O wrong
expect 2 'bits' "$rectilin" render one.off --bits 12 -O wrong
expect 2 'bits' "$rectilin" render one.off --bits 16 --shaded -O wrong
expect 2 'out' "$rectilin" render one.off
expect 2 'file, not a folder' "$rectilin" render one.off -O one.off
[ ! -e wrong ] || fail 'wrong is not written'

# Silhouettes: an interval around what is known.
holds() { # holds AREA COMMAND...: every line's interval holds the area
  local area=$1; shift
  "$@" >out 2>err || fail "$*"
  python3 - "$area" <<'PY' || fail "$* holds $area"
import json, sys
area = float(sys.argv[1])
lines = [json.loads(line) for line in open("out")]
sys.exit(not lines or any(not l["lower"] <= area * (1 + 1e-12) <= l["upper"] * (1 + 2e-12) for l in lines))
PY
}
holds 0.5 "$rectilin" silhouette --json one.off --direction 0,0,1 --direction 0,0,-3
holds 1 "$rectilin" silhouette --json shape:box
holds 1.7320508075688772 "$rectilin" silhouette --json shape:box -d 1,1,1 -d -1,1,-1 --tolerance 1e-9
expect 0 'shape:box .* 1,2,3 ' "$rectilin" silhouette shape:box -d 1,2,3 --picture shadow.png
[ "$(header shadow.png 1 3)" = " 80 78 71" ] || fail "a PNG file"
[ "$("$rectilin" silhouette --json shape:blob --views 66 | wc -l)" -eq 66 ] || fail "66 lines"
expect 1 '"error":"bad.off' "$rectilin" silhouette --json bad.off one.off
expect 2 'three numbers' "$rectilin" silhouette one.off -d 1,2
expect 2 'three numbers' "$rectilin" silhouette one.off -d 0,0,0
expect 2 'three numbers' "$rectilin" silhouette one.off -d 1,2,nan
expect 2 'three numbers' "$rectilin" silhouette one.off -d 1,2,3,4
expect 2 'tolerance' "$rectilin" silhouette one.off --tolerance -1
expect 2 'one mesh and one direction' "$rectilin" silhouette one.off --picture x.png
expect 2 'look like a mesh' "$rectilin" silhouette one.off -d 1,0,0 --picture one.off
expect 2 'xcludes' "$rectilin" silhouette one.off -d 1,0,0 --views 6

finish render
