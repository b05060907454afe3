#!/usr/bin/env bash
# Files and systems as they are: meshes that are not whole, names of any kind, lists, folders, signals.
# Usage: files.sh RECTILIN
. "$(dirname "$0")/expect.sh"

measure=("$rectilin" measure -o 'grid?keep=1' -b 200)
# succeeds COMMAND...: without a word on standard error
succeeds() {
  "$@" >out 2>err </dev/null && [ ! -s err ] || fail "$*"
}
one_line() { [ "$(wc -l <err)" -eq 1 ] || fail "one line on standard error: $1"; }
# area FILE: what measure says
area() { "$rectilin" measure --json -o random -b 1 "$1" 2>/dev/null | grep -o '"area":[^,]*'; }

# --- Meshes that are not what they seem -----------------------------------------------------------------------------

"$rectilin" convert shape:pyramid p.stl && "$rectilin" convert shape:pyramid p.ply && "$rectilin" convert shape:pyramid p.off &&
  "$rectilin" convert --text shape:pyramid text.stl && "$rectilin" convert shape:pyramid p.obj || fail 'the command itself'
n=$(area p.off)

# refused FILE PATTERN: in every command that reads meshes, with one line and nothing written
refused() {
  expect 1 "$2" "${measure[@]}" "$1"; one_line "measure $1"
  expect 1 "$2" "$rectilin" convert "$1" converted.off; one_line "convert $1"
  [ ! -e converted.off ] || fail "nothing is converted from $1"
}
cp /bin/true program.stl;                              refused program.stl 'a program'
cat p.stl p.stl >two.stl;                              refused two.stl '2 binary STL files'
{ cat p.stl; printf 'more'; } >more.stl;               refused more.stl '4 bytes follow'
{ head -c 80 p.stl; printf '\1\0\0\0'; tail -c +85 p.stl; } >low.stl; refused low.stl 'claims 1 triangles'
{ head -c 80 p.stl; printf '\0\0\0\0'; tail -c +85 p.stl; } >none.stl; refused none.stl 'claims 0 triangles'
head -c 200 p.stl >short.stl;                          refused short.stl 'the file holds 2'
printf '<!DOCTYPE html><title>404</title>%200s' '' >page.stl; refused page.stl 'a web page'
printf 'version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n' >lfs.stl; refused lfs.stl 'Git LFS'
gzip -c p.stl >zipped.stl;                             refused zipped.stl 'gzip'
printf 'ISO-10303-21;\nHEADER;%200s' '' >step.stl;     refused step.stl 'a STEP file'
gzip -c p.off >zipped.off;                             refused zipped.off 'gzip'
tar cf tar.stl p.stl;                                  refused tar.stl 'a TAR archive'
iconv -t UTF-16LE text.stl >wide.stl;                  refused wide.stl 'UTF-16'
iconv -t UTF-16LE p.obj >wide.obj;                     refused wide.obj 'UTF-16'
cat p.stl text.stl >mixed.stl;                         refused mixed.stl 'bytes follow them'
head -c 100000 /dev/zero >zero.stl;                    refused zero.stl 'claims 0 triangles'
head -c 5000 /dev/urandom | base64 >text64.stl;        refused text64.stl "neither text that begins with 'solid' nor"
{ printf 'solid '; tail -c +7 p.stl | head -c 250; } >cut.stl; refused cut.stl 'the file holds 3'
sed '3s/./\x00/' text.stl >nul.stl;                     refused nul.stl 'line 3: a NUL character'
sed '1s/$/ a\x00b/' text.stl >nul1.stl;                 refused nul1.stl 'line 1: a NUL character'
sed '5s/$/ word/' p.off >word.off;                     refused word.off 'line 5: expected a number or the end'
"$rectilin" convert 'shape:sphere?subdivisions=2' s.ply && sed 's/$/\r/' s.ply >crlf.ply
refused crlf.ply 'vertex index|copied as text|claims'
for line in 'v,0,1,0' 'v;0;1;0' 'vO 1 0' 'vv0 1 0' '0,1,0' 'f,1,2,3' 'fl 2 3' '"v" 0 1 0' 'v: 0 1 0' '//v 0 1 0'; do
  printf 'v 0 0 0\nv 1 0 0\n%s\nv 1 1 0\nv 0 1 0\nf 1 2 3\n' "$line" >odd.obj; refused odd.obj 'line 3: '
done
printf 'v 0 0 0\nv 1 0 0\n0 1 0\nv 1 1 0\nf 1 2 3\n' >missing.obj; refused missing.obj 'line 3: '
printf 'v 0 0 0\nv 1 0 0\nV 0 1 0\nv 1 1 0\nf 1 2 3\n' >capital.obj; refused capital.obj 'line 3: '
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\ncall more.obj\nf 1 2 3\n' >call.obj; refused call.obj 'line 4: '

# reported FILE PATTERN: read, with a line on standard error and in the report
reported() {
  expect 0 "$1: .*$2" "${measure[@]}" "$1"; one_line "measure $1"
  expect 0 "$1: .*$2" "$rectilin" convert "$1" converted.off; one_line "convert $1"
  rm -f converted.off
  [ "$(area "$1")" = "${3-$n}" ] || fail "the area of $1"
}
{ cat p.stl; printf ' \0\r\n'; } >padded.stl;          reported padded.stl '4 bytes of padding' "$(area p.stl)"
{ cat text.stl; printf '\32'; } >dos.stl;              reported dos.stl '1 byte of padding'
{ cat p.off; printf '# note\n3 0 1 2\n'; } >more.off;  reported more.off '7 bytes of data behind the last face \(line 15\)'
cat p.off p.off >two.off;                              reported two.off 'bytes of data behind'
{ cat p.ply; printf 'more'; } >more.ply;               reported more.ply '4 bytes of data behind'
{ cat p.obj; printf 'surf 0 1 0 1 1 2 x\nzap\n'; } >surf.obj; reported surf.obj "2 statements that may be surface \('surf' in line 12\)"
{ cat p.obj; printf 'surf 0.0 1.0 0.0 1.0 1 2 3 4\nbzp 1 2 3 4\n'; } >free.obj
reported free.obj "2 statements that may be surface \('surf' in line 12\)"
{ cat p.off; printf '\0more'; } >nul.off;              reported nul.off '5 bytes of data behind'
cat p.ply p.ply >two.ply;                              reported two.ply 'bytes of data behind'
sed 's/element face 6/element face 5/' p.ply >count.ply; reported count.ply '13 bytes of data behind' "$(sed '2s/6/5/' p.off >five.off; area five.off)"
sed 's/^endloop/endloop outer loop vertex 0 0 5 vertex 1 0 5 vertex 0 1 5 endloop/;t' text.stl >loops.stl
expect 0 '^loops.stl +12 ' "${measure[@]}" loops.stl
{ cat p.obj; printf 'f 1 2\n'; } >edge.obj;            reported edge.obj '1 face of fewer than three corners'
{ cat p.obj; printf 'v nan 0 0\nf 1 2 6\n'; } >nan.obj; reported nan.obj '1 face with a coordinate that is not'
sed 's/^endloop/vertex 9 9 9\nendloop/;t' text.stl >odd.stl
expect 0 'odd.stl: .*facets of other than three corners' "${measure[@]}" odd.stl
expect 0 '"left_over_bytes":7,"left_over_place":"line 15"' "${measure[@]}" --json more.off
expect 0 "\"unknown_statements\":2,\"first_unknown\":\"'surf' in line 12\"" "${measure[@]}" --json surf.obj

# Every command says it, on standard error and in what it writes.
cp more.off left.off
says_so() { expect "$1" 'left.off: left out: 7 bytes of data behind the last face \(line 15\)' "${@:2}"; [ "$(grep -c 'left out' err)" -eq 1 ] || fail "once: ${*:2}"; }
noted() { grep -q 'left out: 7 bytes\|"left_over_bytes": *7' "$@" || fail "what was left out is in $*"; }
says_so 0 "$rectilin" pose --json left.off; noted out
says_so 0 "$rectilin" silhouette --json -d 0,0,1 left.off; noted out
says_so 0 "$rectilin" render -v 6 -s 8 -O rendered left.off
says_so 0 "$rectilin" validate --claims eq-12 left.off
says_so 0 "$rectilin" validate --claims eq-12 --json left.off; noted out
for again in 1 2; do
  says_so 0 "$rectilin" compare -o random -k 1 -b 10 -O compared left.off shape:box
  noted compared/meshes.csv; noted compared/index.html; noted compared/summary.json
done
says_so 0 "$rectilin" suite -O suite left.off; noted suite/suite.json; noted suite/left.json
says_so 0 "$rectilin" measure -o left.db left.off
"$rectilin" export left.db -o left.jsonl >out 2>err; noted left.jsonl
for experiment in fig11 gap 'fig7?largest=1000' 'shortfall?poses=1' fig12 fig20 'pose-accuracy?turns=1'; do
  "$rectilin" experiment "$experiment" --quick -O figures left.off >out 2>err
  grep -q 'left.off: left out' err || fail "experiment $experiment"
  noted figures/"${experiment%%\?*}".json; noted figures/index.html; rm -rf figures
done
mkdir collection; cp left.off collection/m1.off; cp p.off collection/m2.off
printf 'PSB 1\n1 2\n\nall 0 2\n1\n2\n' >all.cla
for again in 1 2; do  # the second time from the signatures that are kept
  expect 0 'm1.off: left out: 7 bytes' "$rectilin" evaluate collection -c all.cla -d d2 -O evaluated
  noted evaluated/summary.json; noted evaluated/index.html
done
expect 0 'left.off: left out: 7 bytes' "$rectilin" verify <("$rectilin" measure --proof /dev/stdout --json p.off | tail -n 1) left.off

# read FILE: without a word
read_as_is() {
  expect 0 "^$1" "${measure[@]}" "$1"
  [ ! -s err ] && [ "$(area "$1")" = "$n" ] || fail "$1 is read"
}
sed 's/^f /fo /' p.obj >old.obj;                       read_as_is old.obj
tr '\n' ' ' <text.stl >line.stl;                       read_as_is line.stl
sed 's/^end/end /' text.stl >apart.stl;                read_as_is apart.stl
sed 's/^OFF/off/' p.off >small.off;                    read_as_is small.off
tail -n +2 p.off >keyless.off;                         read_as_is keyless.off
sed '2s/ /\n/g' p.off >counts.off;                     read_as_is counts.off
"$rectilin" convert --text p.off text.ply && sed '/^end_header/,$s/ \([^ ]*\)$/\n\1/' text.ply >lines.ply
read_as_is lines.ply

# From pipes, by content.
for file in p.off p.ply p.stl text.stl p.obj; do
  gzip -c $file >pipe.gz
  expect 0 ' 0\.' "${measure[@]}" <(zcat pipe.gz)
  "${measure[@]}" /dev/stdin <$file >out 2>err || fail "$file on standard input"
  zcat pipe.gz | "${measure[@]}" /dev/stdin >out 2>err || fail "$file through a pipe"
done
mkfifo pipe.off; cat p.off >pipe.off & expect 0 'pipe.off' "${measure[@]}" pipe.off; wait
expect 1 'is a device' "${measure[@]}" /dev/zero
expect 0 'fig11: ' "$rectilin" experiment fig11 --quick -O piped <(cat p.off) <(cat p.ply)
expect 0 'piped/index.html' "$rectilin" compare -o random -k 1 -b 10 --objective silhouette -O piped <(cat p.off)
for file in p.off p.ply text.stl; do
  "${measure[@]}" - <$file >out 2>err; [ $? -eq 1 ] && grep -q 'standard input: a mesh, not a list' err || fail "$file instead of a list"
done

# --- Conversion to binary STL -----------------------------------------------------------------------------------------

{ printf 'OFF\n4 4 0\n'; printf '4500000.3 5100000.4 %s\n' 0 1; printf '4500001.6 5100000.4 0\n4500000.3 5100001.3 0\n'
  printf '3 0 1 2\n3 0 1 3\n3 0 2 3\n3 1 2 3\n'; } >utm.off
expect 1 'single precision.*--recentre' "$rectilin" convert utm.off utm.stl
[ ! -e utm.stl ] || fail 'nothing of a mesh that single precision destroys'
succeeds "$rectilin" convert --recentre utm.off utm.stl
r() { "$rectilin" measure --json "$1" | grep -o '"rectilinearity":[0-9.]*' | cut -c1-24; }
[ "$(r utm.stl)" = "$(r utm.off)" ] && [ "$(area utm.stl | cut -c1-13)" = "$(area utm.off | cut -c1-13)" ] ||
  fail 'area and R of what was written'
succeeds "$rectilin" convert --text utm.off text-utm.stl
[ "$(area text-utm.stl)" = "$(area utm.off)" ] || fail 'text keeps all'
{ printf 'OFF\n4 4 0\n0 0 0\n0 0 1e-50\n1e-50 0 0\n0 1e-50 0\n'; tail -n 4 utm.off; } >tiny.off
expect 1 'single precision' "$rectilin" convert tiny.off tiny.stl
expect 1 'single precision' "$rectilin" convert --recentre tiny.off tiny.stl

# --- Lists and folders ------------------------------------------------------------------------------------------------

mkdir -p tree/sub
cp p.off tree/a.off && cp p.off "tree/sub/b c.off" && cp p.off 'tree/new
line.off' && printf 'resource' >tree/._a.off
list() { "${measure[@]}" --json - <listed >out 2>err; status=$?; rows=$(wc -l <out); }
find tree -name '[!.]*.off' -print0 >listed; list
[ $status -eq 0 ] && [ "$rows" -eq 3 ] && [ ! -s err ] || fail "find -print0"
for text in '\0\n' 'tree/a.off\0tree/a.off' 'tree/a.off\0\0' '\377\376t\0\n\0' 't\0a\0\n\0'; do
  printf "$text" >listed; list
  [ $status -eq 1 ] && [ "$rows" -eq 0 ] && [ "$(wc -l <err)" -eq 1 ] || fail "a list with NUL: $text"
done
printf '\357\273\277tree/a.off\r\ntree/sub/b c.off\r\n' >listed; list
[ $status -eq 0 ] && [ "$rows" -eq 2 ] || fail 'a list with a byte order mark'

expect 0 'a.off' "${measure[@]}" tree
[ "$(grep -c '0\.42' out)" -eq 3 ] && [ ! -s err ] || fail "a folder, but for ._a.off"
[ "$(wc -l <out)" -eq 4 ] && grep -q 'new\\nline.off' out || fail 'a name of two lines has one row'
ln -s ../tree tree/again; ln -s loop.off tree/loop.off; ln -s nothing.off tree/gone.off
expect 1 'tree/again: this link leads back' "${measure[@]}" tree
grep -q 'loop.off: too many levels of symbolic links' err && grep -q 'gone.off: no such file' err &&
  [ "$(wc -l <err)" -eq 3 ] && [ "$(grep -c '0\.42' out)" -eq 3 ] || fail 'links that lead nowhere'
for command in 'validate --claims eq-12' 'compare -o random -k 1 -b 10 -O links' 'experiment fig11 --quick -O links-too'; do
  expect 1 'tree/again' "$rectilin" $command tree
done
rm tree/again tree/loop.off tree/gone.off
mkdir elsewhere && cp p.off elsewhere/e.off && ln -s ../elsewhere tree/link
expect 0 'tree/link/e.off' "${measure[@]}" tree
rm tree/link
if [ "$(id -u)" -eq 0 ] && command -v setpriv >/dev/null; then
  chmod 755 . && mkdir -p tree/locked && chmod 000 tree/locked
  user=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  if "${user[@]}" "$rectilin" --version >/dev/null 2>&1; then
    expect 1 'tree/locked: permission denied' "${user[@]}" "${measure[@]}" tree
    [ "$(grep -c '0\.42' out)" -eq 3 ] || fail 'files beside a folder that cannot be read'
    chmod 000 p.ply; expect 1 'p.ply: permission denied' "${user[@]}" "${measure[@]}" p.ply; chmod 644 p.ply
    expect 1 'own.off: cannot be written: permission denied' "${user[@]}" "$rectilin" convert p.off own.off
  fi
  chmod 755 tree/locked
elif [ "$(id -u)" -ne 0 ]; then
  mkdir -p tree/locked && chmod 000 tree/locked
  expect 1 'tree/locked: permission denied' "${measure[@]}" tree
  chmod 755 tree/locked
fi
rm -rf tree/locked
# Lists in files.
printf 'p.off\0p.stl\0' >nul.txt;               expect 1 'nul.txt:line 1: a NUL character' "${measure[@]}" nul.txt
printf 'source\np.off\np\0.off\n' >nul.csv;    expect 1 'nul.csv:line 3: a NUL character' "${measure[@]}" nul.csv
printf 'p.off\n' | iconv -t UTF-16 >wide.txt;   expect 1 'wide.txt: a list in UTF-16' "${measure[@]}" wide.txt
printf '\357\273\277source,name\r\np.off,a\r\n' >marked.csv; expect 0 '^p.off' "${measure[@]}" marked.csv
mkdir list.csv;                                 expect 1 'list.csv: no mesh file in this folder' "${measure[@]}" list.csv

# --- Messages -----------------------------------------------------------------------------------------------------------

long=$(printf 'n%.0s' {1..251})
ln -s self self
expect 1 'none.off: no such file or directory' "${measure[@]}" none.off
expect 1 'self: too many levels of symbolic links' "${measure[@]}" self
expect 1 'p.off/x.off: not a directory' "${measure[@]}" p.off/x.off
expect 1 ': file name too long' "${measure[@]}" "$long-more.off"
expect 1 'p.off/x.off: cannot be written: not a directory' "$rectilin" convert p.off p.off/x.off
expect 1 'none.json: no such file or directory' "$rectilin" verify none.json p.off
expect 1 'p.off/x.zip: not a directory' "${measure[@]}" p.off/x.zip
expect 1 'none.7z: no such file or directory' "${measure[@]}" none.7z
expect 1 'none.zip: no such file or directory' "${measure[@]}" none.zip::x.off
expect 1 'p.off/x.ply: not a directory' "$rectilin" measure --normals p.off/x.ply
expect 1 'self: too many levels' "$rectilin" evaluate tree -c self -d d2
expect 1 'p.off/x.cla: not a directory' "$rectilin" evaluate tree -c p.off/x.cla -d d2
expect 1 'none.db: no such file or directory' "$rectilin" corpus status none.db
expect 1 'p.off/x.db: cannot be written: not a directory|p.off/x.db: not a directory' "$rectilin" measure p.off -o p.off/x.db
expect 1 'standard output: cannot be written: no space left' sh -c '"$1" measure p.off >/dev/full' sh "$rectilin"
expect 1 'standard output: cannot be written: no space left' sh -c '"$1" shapes >/dev/full' sh "$rectilin"
expect 1 'a\\nb\\x1B\[31m.off: no such file' "${measure[@]}" "$(printf 'a\nb\033[31m.off')"
one_line 'a name of two lines'
grep -q "$(printf '\033')" err && fail 'an escape character reaches the terminal'
expect 1 'no\\xFF.off: no such file' "${measure[@]}" "$(printf 'no\377.off')"
cp p.off 'чайник.off'; cp p.off '茶壺.off'
expect 0 'чайник' "${measure[@]}" 'чайник.off' '茶壺.off' p.off
grep -q '^чайник.off         6 ' out && grep -q '^茶壺.off           6 ' out && grep -q '^p.off              6 ' out ||
  fail 'columns stand below each other'

# --- Files that are written -----------------------------------------------------------------------------------------------

echo mine >q.off.new
succeeds "$rectilin" convert p.off q.off
[ "$(cat q.off.new)" = mine ] || fail "a user's file of another name"
succeeds "$rectilin" convert p.off "$long.off"
succeeds "$rectilin" convert p.off "$long.off"
cmp -s p.off "$long.off" || fail 'a name of 255 bytes'
chmod 600 q.off; succeeds "$rectilin" convert p.off q.off
[ "$(stat -c %a q.off)" = 600 ] || fail 'the permissions of what is replaced'
ln -s q.off link.off; succeeds "$rectilin" convert shape:box link.off
[ -L link.off ] && [ "$(stat -c %a q.off)" = 600 ] && ! cmp -s p.off q.off || fail 'a link stays'
expect 2 'proof' "$rectilin" measure --proof '' p.off
"$rectilin" measure p.off "$work/p.ply" -o box.db >out 2>err || fail 'a store'
echo mine >box.csv.new; echo old >box.csv; chmod 600 box.csv
expect 0 'box.csv' "$rectilin" export box.db -o box.csv
[ "$(cat box.csv.new)" = mine ] && [ "$(stat -c %a box.csv)" = 600 ] && [ "$(wc -l <box.csv)" -eq 3 ] || fail 'an export'
expect 1 'p.off/a.csv: cannot be written: not a directory' "$rectilin" export box.db -o p.off/a.csv

mkdir signals
for signal in INT TERM HUP KILL; do
  for delay in 0.05 0.15 0.3 0.6; do
    begin "$rectilin" convert 'shape:blob?faces=400000' signals/blob.obj
    sleep $delay; kill -$signal $pid 2>/dev/null; wait $pid 2>/dev/null
    [ -z "$(ls -A signals | grep -v '^blob.obj$')" ] || fail "unfinished files after $signal"
    rm -f signals/*
  done
done

# SIGTERM is Ctrl-C; an ignored SIGINT stays ignored, as it is behind nohup and & in scripts.
for signal in TERM INT HUP; do
  begin "$rectilin" measure -o random --seconds 60 shape:box shape:pyramid
  sleep 1; kill -$signal $pid; wait $pid
  [ $? -eq 1 ] && grep -q '^shape:' out || fail "SIG$signal stops, and what is in work is shown"
done
(trap '' INT; exec "$rectilin" measure -o random --seconds 2 shape:box >out 2>err) &
pid=$!; sleep 1; kill -INT $pid; wait $pid
[ $? -eq 0 ] || fail 'an ignored SIGINT stays ignored'

finish files
