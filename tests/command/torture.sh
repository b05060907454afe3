#!/usr/bin/env bash
# pose, index and compare, each killed at twenty random moments: what they leave, run to its end, is what an undisturbed
# run makes, bit for bit.  Usage: torture.sh RECTILIN [KILLS]
. "$(dirname "$0")/expect.sh"

RANDOM=7
kills=${2:-20}
mkdir meshes
for i in $(seq 3 42); do "$rectilin" convert "shape:prism?sides=$i" meshes/prism$i.off || fail convert; done
for i in $(seq 40); do "$rectilin" convert "shape:blob?faces=2000&seed=$i" meshes/blob$i.off || fail convert; done
cp meshes/blob7.off meshes/copy.off
printf 'OFF\nrubbish\n' >meshes/bad.off

done_in() {
  { "$rectilin" corpus status "$1" 2>/dev/null || true; } | awk 'NR == 2 {n = $(NF - 5)} END {print n + 0}'
}

# torture FILE CHECK COMMAND...: kills the command again and again, with all its workers, at any moment, while it starts
# included; every second time not before it has got on a little, however slow the machine. Whenever it gets to its end,
# CHECK looks at the file, and it begins anew.
torture() {
  local file=$1 check=$2 before hits=0 ends=0 k; shift 2
  for ((k = 0; hits < kills; ++k)); do
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
    if [ $? -eq 137 ]; then
      hits=$((hits + 1))
    else
      ends=$((ends + 1))
      $check "$file"
      rm -f "$file"*
    fi
  done
  "$@" >out 2>err </dev/null
  $check "$file"
  echo "$file: $kills kills, came to its end $((ends + 1)) times"
}

# The rows of a store without times; of a database of shapes, what is searched in it.
bits() { "$rectilin" export "$1" -o "$1.jsonl" >/dev/null && sed -E 's/"(cpu_)?seconds":[^,]*,//g; s/"times":.*/"/' "$1.jsonl"; }
found() { "$rectilin" search "$1" --like meshes/blob3.off --like meshes/prism9.off -n 100 --json; }

same_rows() { bits "$1" >b && cmp "calm-$1.bits" b || fail "the rows of a run that was left alone: $1"; }
same_shapes() { found "$1" >b && cmp "calm-$1.found" b || fail "the signatures of a run that was left alone: $1"; }

pose=("$rectilin" pose meshes --threads 2)
"${pose[@]}" -o calm-poses.db >/dev/null 2>&1
bits calm-poses.db >calm-pose.db.bits
[ "$(wc -l <calm-pose.db.bits)" -eq 82 ] || fail 'a row for each mesh'
torture pose.db same_rows "${pose[@]}" -o pose.db

index=("$rectilin" index meshes --threads 2 -d 'gsmd?views=18+r')
"${index[@]}" -o calm-index.db >/dev/null 2>&1
found calm-index.db >calm-index.db.found
[ "$(grep -o '"rank"' calm-index.db.found | wc -l)" -eq 160 ] || fail 'a signature for each mesh'
torture index.db same_shapes "${index[@]}" -o index.db
expect 0 'index.db .* 81 +1 +0 +0 ' "$rectilin" corpus status index.db

compare=("$rectilin" compare shape:box shape:pyramid -k 20 -b 2000 --threads 2 -o 'ga,random')
"${compare[@]}" -o calm-runs.db >/dev/null 2>&1
bits calm-runs.db >calm-compare.db.bits
[ "$(wc -l <calm-compare.db.bits)" -eq 82 ] || fail 'bounds and runs'
torture compare.db same_rows "${compare[@]}" -o compare.db

finish torture
