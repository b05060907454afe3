#!/usr/bin/env bash
# A corpus as a job array on a Slurm of our own, which runs on the loopback device of this machine: tasks are requeued,
# cancelled and submitted again, a worker is killed, and the results are those of a run without Slurm, bit for bit.
# Usage: slurm.sh RECTILIN        Status 77: skipped, because there is no Slurm and it cannot be installed.
scripts=$(realpath "$(dirname "$0")/../../scripts/slurm")
. "$(dirname "$0")/expect.sh"

skip() { echo "skipped: $*"; exit 77; }
[ "$(id -u)" -eq 0 ] || skip 'a Slurm of our own needs root'
if ! command -v slurmctld slurmd munged sbatch >/dev/null; then
  command -v apt-get >/dev/null && { apt-get update -q && DEBIAN_FRONTEND=noninteractive apt-get install -q -y \
    --no-install-recommends slurm-wlm munge; } >/dev/null 2>&1 || skip 'slurm-wlm and munge cannot be installed'
fi

host=$(hostname -s)
daemons=()
stop_daemons() {
  [ ${#daemons[@]} -eq 0 ] || kill "${daemons[@]}" 2>/dev/null
  wait 2>/dev/null
  rm -rf "$work"
}
trap stop_daemons EXIT
ports=($(shuf -i 20000-30000 -n 2))
export SLURM_CONF=$work/slurm.conf
chmod 755 "$work"
mkdir -p state spool
cat >slurm.conf <<END
ClusterName=rectilin
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
SlurmctldPort=${ports[0]}
SlurmdPort=${ports[1]}
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$work/munge.socket,cred_expire=5
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SlurmdParameters=config_overrides
SchedulerParameters=sched_interval=1,bf_interval=1
ReturnToService=2
MpiDefault=none
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 RealMemory=8000 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES State=UP
END
dd if=/dev/urandom of=munge.key bs=1 count=1024 2>/dev/null
chmod 600 munge.key
munged --foreground --force --key-file="$work/munge.key" --socket="$work/munge.socket" --pid-file="$work/munge.pid" \
  --log-file="$work/munge.log" --seed-file="$work/munge.seed" >/dev/null 2>&1 & daemons+=($!)
for _ in $(seq 50); do [ -S munge.socket ] && break; sleep 0.1; done
slurmctld -D >/dev/null 2>&1 & daemons+=($!)
slurmd -D -N "$host" >/dev/null 2>&1 & daemons+=($!)
for _ in $(seq 100); do sinfo -h -o %t 2>/dev/null | grep -q idle && break; sleep 0.2; done
sinfo -h -o %t 2>/dev/null | grep -q idle || skip "Slurm does not start here: $(tail -n 2 slurmctld.log slurmd.log munge.log 2>/dev/null)"

# Shapes that take some tens of milliseconds each, some of them twice, and two that cannot be measured.
{
  for i in $(seq 240); do echo "shape:blob?faces=20000&seed=$i"; done
  for i in $(seq 20); do printf 'copy of %d,shape:blob?faces=20000&seed=%d\n' "$i" "$i" >>copies.csv; done
  echo missing.off
  echo 'shape:box?size=1'
} >list.txt
sed -i '1i name,path' copies.csv
"$rectilin" measure "$work/list.txt" "$work/copies.csv" --out plain.db --threads 2 >out 2>err || fail 'the run without Slurm'

export RECTILIN=$rectilin OUT=$work/corpus
submit() { sbatch --parsable --cpus-per-task=1 --mem-per-cpu=1500 --output="$work/%x-%A_%a.log" "$@"; }
running() { squeue -h -t R -o %i 2>/dev/null | grep -qx "$1"; }
array=$(submit --array=0-3 "$scripts/corpus.sbatch" "$work/list.txt" "$work/copies.csv") || fail 'sbatch'
for _ in $(seq 200); do [ -s "$OUT/shard-1-of-4.db" ] && [ -s "$OUT/shard-2-of-4.db" ] && break; sleep 0.1; done
running "${array}_1" && scontrol requeue "${array}_1" || fail 'task 1 is not running, or not requeued'
running "${array}_2" && scancel "${array}_2" || fail 'task 2 is not running, or not cancelled'
# A worker of task 3: a process below it, by its number.
task=$(pgrep -f -- "--shard 3/4" | head -n 1)
worker=$(pgrep -P "${task:-0}" | head -n 1)
kill -9 "${worker:-0}" 2>/dev/null || fail 'no worker of task 3 to kill'
expect 0 'shard-3-of-4.db +3/4' "$rectilin" corpus status "$OUT"/shard-*.db

for _ in $(seq 240); do squeue -h -t CG,R -o %i | grep -q "${array}_2" || break; sleep 0.5; done
export SHARDS=4
again=$(submit --array=2 "$scripts/corpus.sbatch" "$work/list.txt" "$work/copies.csv") || fail 'sbatch again'
merge=$(submit --dependency="afterany:$array:$again" "$scripts/corpus.sbatch") || fail 'sbatch of the merge'
for _ in $(seq 600); do [ -z "$(squeue -h)" ] && break; sleep 0.5; done
cat rectilin-*.log >out 2>&1
[ -z "$(squeue -h)" ] || fail "jobs do not end: $(squeue)"
expect 0 ' 0 +' "$rectilin" corpus status --check "$OUT/all.db"

bits() {
  "$rectilin" export "$1" -o "$2.jsonl" >/dev/null &&
    sed -E 's/,"seconds":[^,]*,"version"/,"version"/' "$2.jsonl" >"$2.bits"
}
bits plain.db plain && bits "$OUT/all.db" all || fail 'export'
[ "$(wc -l <plain.bits)" -eq 262 ] && cmp plain.bits all.bits || fail 'the bits of the run without Slurm'
[ "$(grep -c '"status":"failed"' all.bits)" -eq 2 ] || fail 'two meshes that cannot be measured'

# The other commands: a comparison, of which the merge makes the page, and an index with a file that is no mesh.
unset SHARDS
in_array() {
  local array
  array=$(submit --array=0-2 "$scripts/corpus.sbatch" "$@") || fail "sbatch of $COMMAND"
  submit --dependency="afterok:$array" "$scripts/corpus.sbatch" >/dev/null || fail "sbatch of the merge of $COMMAND"
  for _ in $(seq 600); do [ -z "$(squeue -h)" ] && break; sleep 0.5; done
  cat rectilin-*.log >out 2>&1
}
lines() { sed -E 's/"(cpu_)?seconds":(\[[^]]*\]|[^,]*)//g; s/"threads":[0-9]*//' "$1" | sort; }
export COMMAND=compare OUT=$work/compared
"$rectilin" compare shape:box shape:pyramid -o ga,random -k 5 -b 300 -O plain >/dev/null 2>&1
in_array shape:box shape:pyramid -o ga,random -k 5 -b 300
[ -s "$OUT/comparison/index.html" ] || fail 'the page of the comparison'
lines plain/runs.jsonl >a; lines "$OUT/comparison/runs.jsonl" >b
[ "$(wc -l <b)" -eq 20 ] && cmp a b || fail 'the runs of the comparison without Slurm'

export COMMAND=index OUT=$work/indexed
for i in 3 4 5 6 7 8 9; do echo "shape:prism?sides=$i"; done >shapes.txt
echo missing.off >>shapes.txt
"$rectilin" index "$work/shapes.txt" -o shapes.db -d r >/dev/null 2>&1
in_array "$work/shapes.txt" -d r
for file in shapes.db "$OUT/all.db"; do "$rectilin" search "$file" --like 'shape:prism?sides=5' --json; done >out 2>&1
[ "$(wc -l <out)" -eq 2 ] && [ "$(sort -u out | wc -l)" -eq 1 ] || fail 'the shapes of an index without Slurm'

finish slurm
