#!/usr/bin/env bash
# pose, index and compare, each killed at fifty random moments: what they leave, run to its end, is what an undisturbed
# run makes, bit for bit.  Usage: torture.sh RECTILIN
. "$(dirname "$0")/expect.sh"

RANDOM=7
kills=50
mkdir meshes
for i in $(seq 3 42); do "$rectilin" convert "shape:prism?sides=$i" meshes/prism$i.off || fail convert; done
for i in $(seq 40); do "$rectilin" convert "shape:blob?faces=2000&seed=$i" meshes/blob$i.off || fail convert; done
cp meshes/blob7.off meshes/copy.off
printf 'OFF\nrubbish\n' >meshes/bad.off

done_in() {
  { "$rectilin" corpus status "$1" 2>/dev/null || true; } | awk 'NR == 2 {n = $(NF - 5)} END {print n + 0}'
}

# torture FILE COMMAND...: kills the command again and again, with all its workers, at any moment, while it starts
# included; every second time not before it has got on a little, however slow the machine.
torture() {
  local file=$1 before; shift
  for ((k = 0; k < kills; ++k)); do
    before=$(done_in "$file")
    "$@" >/dev/null 2>&1 </dev/null &
    local pid=$!
    if ((k % 2)); then
      for ((i = 0; i < 600; ++i)); do
        kill -0 $pid 2>/dev/null && [ "$(done_in "$file")" -le "$before" ] || break
        sleep 0.01
      done
    fi
    sleep 0.0$((RANDOM % 10))$((RANDOM % 10))
    kill -9 $pid 2>/dev/null
    wait $pid 2>/dev/null
  done
  echo "$(basename "$file"): $(done_in "$file") rows after $kills kills"
  [ "$(done_in "$file")" -ge 20 ] || fail "$file: kills keep it from getting on"
  "$@" >out 2>err </dev/null
}

# The rows of a store without times; of a database of shapes, what is searched in it.
bits() { "$rectilin" export "$1" -o "$1.jsonl" >/dev/null && sed -E 's/"(cpu_)?seconds":[^,]*,//g; s/"times":.*/"/' "$1.jsonl"; }
found() { "$rectilin" search "$1" --like meshes/blob3.off --like meshes/prism9.off -n 100 --json; }

pose=("$rectilin" pose meshes --threads 2)
"${pose[@]}" -o calm-pose.db >/dev/null 2>&1
torture pose.db "${pose[@]}" -o pose.db
bits calm-pose.db >a && bits pose.db >b && cmp a b || fail 'the poses of a run that was left alone'
[ "$(wc -l <b)" -eq 82 ] || fail 'a row for each mesh'

index=("$rectilin" index meshes --threads 2 -d 'gsmd?views=18+r')
"${index[@]}" -o calm-index.db >/dev/null 2>&1
torture index.db "${index[@]}" -o index.db
found calm-index.db >a && found index.db >b && cmp a b || fail 'the signatures of a run that was left alone'
expect 0 'index.db .* 81 +1 +0 +0 ' "$rectilin" corpus status index.db

compare=("$rectilin" compare shape:box shape:pyramid -k 20 -b 2000 --threads 2 -o 'ga,random')
"${compare[@]}" -o calm-compare.db >/dev/null 2>&1
torture compare.db "${compare[@]}" -o compare.db
bits calm-compare.db >a && bits compare.db >b && cmp a b || fail 'the comparison of a run that was left alone'
[ "$(wc -l <b)" -eq 82 ] || fail 'bounds and runs'

finish torture
