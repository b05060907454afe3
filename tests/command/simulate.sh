#!/usr/bin/env bash
# The simulation of job arrays, on a store of this program.  Usage: simulate.sh RECTILIN
simulate=$(realpath "$(dirname "$0")/../../scripts/slurm/simulate.py")
. "$(dirname "$0")/expect.sh"
command -v python3 >/dev/null || { echo 'simulate: skipped, as there is no python3'; exit 77; }

for faces in 100 200 400 800; do echo "shape:blob?faces=$faces"; done >list.txt
echo 'nothing.off' >>list.txt
expect 0 '4 done, 1 failed' "$rectilin" measure list.txt -o few.db

# The numbers of the last line: 3 hours, 4 merge, 5 efficiency (6 is its %), 7 interrupted, 8 begun twice.
column() { awk -v n="$1" 'END { print $n }' out; }
holds() { python3 -c "import sys; sys.exit(not ($1))" || fail "$1"; }

# Every mesh takes 2 s: then the time can be told by hand.
python3 -c "
import sqlite3
store = sqlite3.connect('few.db')
store.execute('UPDATE meshes SET seconds = 2')
store.commit()"
calm=(--days-between-failures 1e9 --slow-share 0 --start-seconds 1e-9 --merge-microseconds 1e-9)
expect 0 '1600 meshes of 2 s' "$simulate" few.db --meshes 1600 --nodes 1 --cores 4 --shards 1 "${calm[@]}"
holds "abs($(column 3) - 1600 * 2 / 4 / 3600) < 0.001 and $(column 5) == 100"
expect 0 '1600 meshes' "$simulate" few.db --meshes 1600 --nodes 4 --cores 4 --shards 4 "${calm[@]}"
holds "abs($(column 3) - 1600 * 2 / 16 / 3600) < 0.001"
# A mesh more than fits: all wait for one worker.
expect 0 '9 meshes' "$simulate" few.db --meshes 9 --nodes 1 --cores 8 --shards 1 "${calm[@]}"
holds "$(column 5) == 56.2 or $(column 5) == 56.3"
expect 0 'meshes of 1 s' "$simulate" few.db --meshes 1600 --nodes 1 --speed 2 "${calm[@]}"
expect 0 'meshes of 0.5 s' "$simulate" few.db --meshes 1600 --nodes 1 --limit-seconds 0.5 "${calm[@]}"
expect 0 '1600 meshes of 2 s' "$simulate" few.db --meshes 1600 --nodes 1 --cores 4 --together 10 "${calm[@]}"
holds "abs($(column 3) - 1600 * 2 / 4 / 3600) < 0.001 and $(column 5) == 100"
# Beyond the largest mesh, twice the size takes twice the time.
expect 0 'meshes' "$simulate" few.db --meshes 10 --nodes 1 --faces 1e6,1e-9 --limit-seconds 1e9 --hours 1e9 "${calm[@]}"
holds "2 * 1e6 / 800 <= $(sed -n '1s/.* of \([^ ]*\) s on.*/\1/p' out) <= 2 * 1e6 / 100"

# What goes wrong costs time, and all is done in the end.
expect 0 '40000 meshes' "$simulate" few.db --meshes 40000 --nodes 4 --cores 4 "${calm[@]}"
quiet=$(column 3)
expect 0 '40000 meshes' "$simulate" few.db --meshes 40000 --nodes 4 --cores 4 --days-between-failures 0.02 \
  --slow-share 0.2 --hours 0.5
holds "$(column 3) > 1.05 * $quiet and $(column 7) > 3 and $(column 8) > 0 and $(column 5) < 99"

# The same seed gives the same, another seed another history.
storm=(--meshes 40000 --cores 4 --nodes 2 8 --days-between-failures 0.02)
expect 0 meshes "$simulate" few.db "${storm[@]}"; cp out first
expect 0 meshes "$simulate" few.db "${storm[@]}"; cmp out first || fail 'the same seed'
expect 0 meshes "$simulate" few.db "${storm[@]}" --seed 2; cmp -s out first && fail 'another seed'

echo rubbish >rubbish.db
expect 1 'rubbish.db: file is not a database' "$simulate" rubbish.db
expect 1 'none.db: unable to open' "$simulate" none.db
expect 2 "'-3' is not a positive number" "$simulate" few.db --nodes=-3
expect 2 'MEDIAN,SPREAD' "$simulate" few.db --faces 5
expect 2 'begun for ever' "$simulate" few.db --hours 0.1
"$rectilin" measure nothing.off -o failed.db >/dev/null 2>&1
expect 1 'no finished meshes' "$simulate" failed.db

finish simulate
