#!/usr/bin/env bash
# What commands write for people and other programs, when names are of any kind, pictures fail, or journals are foreign.
# Usage: reports.sh RECTILIN
. "$(dirname "$0")/expect.sh"
export LC_ALL=C.UTF-8

"$rectilin" convert shape:pyramid p.off || fail 'the command itself'
long=$(printf 'a%.0s' {1..240})

# Whether a file is XML, where there is something that knows.
if command -v xmllint >/dev/null; then xml() { xmllint --noout "$1" 2>/dev/null; }
elif command -v python3 >/dev/null; then xml() { python3 -c 'import sys, xml.dom.minidom as x; x.parse(sys.argv[1])' "$1" 2>/dev/null; }
else xml() { grep -q '</svg>' "$1"; }
fi

# well_formed FILE...: SVG and HTML are UTF-8 without control characters, and SVG is XML.
well_formed() {
  for file in "$@"; do
    iconv -f UTF-8 -t UTF-8 "$file" >/dev/null 2>&1 || fail "$file is UTF-8"
    grep -qP '[\x00-\x08\x0B\x0C\x0E-\x1F\x7F]' "$file" && fail "$file has control characters"
    case $file in *.svg) xml "$file" || fail "$file is XML" ;; esac
  done
}

# Names that break what does not expect them; each is one mesh.
mkdir odd
n=0
for name in 'чайник из фарфора с очень длинным именем' '茶壺茶壺茶壺茶壺茶壺茶壺茶壺茶壺' 'e%f @NAME@ {a}_b^c' \
  "it's \"quoted\", & <b>" '100%d' "$(printf 'two\nlines')" "$(printf 'esc\033[31m')" "$(printf '\342\200\256rtl')" "$long" '`id` $(id)'; do
  cp p.off "odd/$name.off"; n=$((n + 1))
done
[ "$(ls odd | wc -l)" -ge $n ] || fail 'files of odd names'
expect 0 'odd-out/index.html' "$rectilin" compare odd -o 'random, '"$long"'=grid?keep=1, ключ=random, 50%@zone=grid?keep=1' -k 2 -b 50 -O odd-out
[ ! -s err ] || fail 'nothing to complain of'
well_formed odd-out/index.html odd-out/plots/*.svg
for csv in odd-out/plots/*.csv; do [ -s "${csv%.csv}.svg" ] || fail "$csv has a picture"; done
[ "$(wc -l <odd-out/meshes.csv)" -eq $((n + 1)) ] && [ "$(wc -l <odd-out/runs.csv)" -eq $((n * 8 + 1)) ] ||
  fail 'a line of CSV for each record'
grep -q '100%d' odd-out/plots/heat.svg && grep -q 'e%f @NAME@ {a}_b^c' odd-out/plots/heat.svg || fail '% and @NAME@ are drawn as they are'
grep -q 'чайник' odd-out/plots/heat.svg && grep -q 'two\\nlines' odd-out/index.html || fail 'names are readable'
names=$(cat odd-out/ioh/1-*/IOHprofiler_*.json | grep -o '"function_name": "[^"]*"')
[ "$(sort -u <<<"$names" | wc -l)" -eq $n ] && grep -q 'чайник' <<<"$names" || fail 'IOHprofiler has a readable name for each mesh'

# A contact sheet cuts names by characters; what is not UTF-8 is shown, too.
cp p.off "$(printf 'no\377utf.off')"
expect 0 'sheet/index.html' "$rectilin" experiment fig11 odd "$(printf 'no\377utf.off')" --quick -O sheet
well_formed sheet/index.html sheet/*.svg sheet/*.csv
grep -q 'no\\xFFutf' sheet/fig11*.svg || fail 'a name that is not UTF-8'

# The user's settings of gnuplot change nothing.
mkdir home
printf 'set terminal dumb\nset output "/dev/null"\nset title "MINE"\nexit\n' >home/.gnuplot
expect 0 'fig15' env HOME="$work/home" "$rectilin" experiment 'fig15?steps=2' -O own
grep -q '</svg>' own/fig15.svg && ! grep -q MINE own/fig15.svg || fail "the user's ~/.gnuplot is obeyed"

# A gnuplot that fails: a line for each picture, with its own reason, no old picture, and the status.
mkdir fails
cat >fails/gnuplot <<'SH'
#!/bin/sh
for file; do :; done
case $file in
  runtimes-seconds*) exit 0 ;;
  heat*) echo "broken" >&2; exit 3 ;;
  profile*) kill -9 $$ ;;
  *) exec REAL "$@" ;;
esac
SH
sed -i "s|REAL|$(command -v gnuplot)|" fails/gnuplot; chmod +x fails/gnuplot
compare=("$rectilin" compare shape:pyramid -o random -k 2 -b 50 -O failing)
expect 0 'failing/index.html' "${compare[@]}"
expect 1 'failing/index.html' env PATH="$work/fails:$PATH" "${compare[@]}"
[ "$(wc -l <err)" -eq 3 ] && grep -q 'heat.svg: gnuplot: broken' err && grep -q 'profile.svg: gnuplot: .*signal 9' err &&
  grep -q 'runtimes-seconds.svg: gnuplot: it made no picture' err || fail 'a line for each picture that failed'
[ ! -e failing/plots/heat.svg ] && grep -q 'No picture' failing/index.html || fail 'an old picture is not shown'
echo mine >failing/plots/heat.log
expect 0 'failing/index.html' "${compare[@]}"
[ "$(cat failing/plots/heat.log)" = mine ] || fail "a user's file beside pictures"

# A mesh that was not there is measured once it is.
late=("$rectilin" compare late.off shape:box -o random -k 2 -b 50 -O late)
expect 1 'late.off' "${late[@]}"
cp p.off late.off
expect 0 'late/index.html' "${late[@]}"
[ "$(wc -l <late/runs.csv)" -eq 5 ] && grep -q '^late.off,,4\|^late.off,,6\|^late.off,,' late/meshes.csv || fail 'a mesh that came later'
expect 0 'late/index.html' "${late[@]}"
[ "$(wc -l <late/meshes.jsonl)" -eq 3 ] || fail 'and is measured once'

# Foreign lines name file and line.
for line in 'x' '{}' '[1]' '{"mesh":"other","entry":"random","run":0,"outcome":"finished"}' 'null'; do
  cp -r late foreign && echo "$line" >>foreign/runs.jsonl
  expect 1 'foreign/runs.jsonl:line 5: ' "${late[@]::${#late[@]}-1}" foreign
  [ "$(wc -l <err)" -eq 1 ] || fail "one line for a foreign line $line"
  rm -r foreign
done

# The recorded command line can be pasted into a shell.
odd=$'it\'s a\nname $HOME `x` "q" \\ ~'
expect 0 'index.html' "$rectilin" compare shape:box -o random -k 1 -b 20 -O "$odd"
line=$(sed -n 's/^ *"command_line": "\(.*\)",*$/\1/p' "$odd/provenance.json" | sed 's/\\\(.\)/\1/g')
rm -r "$odd"
eval "$line" >out 2>err </dev/null && [ -s "$odd/index.html" ] || fail "the command line on record: $line"

finish reports
