#!/bin/sh
# slurm.sh HOGELSCOPE: Slurm on this one machine, as root, runs packaging/cluster/report.sbatch: four
# shards, of which one is killed and one cancelled before it starts, then the last step.
set -eu
program=$1
[ "$(id -u)" = 0 ] || { echo "needs root for munged and slurmd"; exit 77; }
script=$(cd "$(dirname "$0")/../../packaging/cluster" && pwd)/report.sbatch
. "$(dirname "$0")/campaign.sh"

node=$(hostname -s)
mkdir spool state
chmod 755 "$folder"
cat > slurm.conf <<C
ClusterName=test
SlurmctldHost=$node
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
AuthInfo=socket=$folder/munge.socket
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=$node NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
C
export SLURM_CONF="$folder/slurm.conf"
head -c 1024 /dev/urandom > munge.key
chmod 400 munge.key
stop_all() {
  for name in slurmd slurmctld munged; do
    [ -f "$name.pid" ] || continue
    process=$(cat "$name.pid")
    kill "$process" || continue
    while kill -0 "$process" 2>/dev/null; do sleep 0.1; done
  done
}
munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
  --pid-file="$folder/munged.pid" --log-file="$folder/munged.log" --seed-file="$folder/munge.seed"
slurmctld
slurmd
until sinfo -h -o %T | grep -q idle; do sleep 1; done

wait_for() { while squeue -h -j "$1" 2>/dev/null | grep -q .; do sleep 1; done; }
# Held, so that the third shard can be cancelled before it starts.
# shellcheck disable=SC2086 # words
job=$(sbatch --parsable --hold --array=1-4 "$script" $arguments --output shared)
# shellcheck disable=SC2086 # words
last=$(sbatch --parsable --dependency="afterany:$job" "$script" $arguments --output shared)
scancel "${job}_3"
scontrol release "$job"
while [ "$(cat shared/report.journal.2-4 2>/dev/null | wc -l)" -lt 2 ]; do sleep 0.05; done
for process in $(pgrep -f -- '--shard 2/4'); do
  [ "$(readlink "/proc/$process/cwd")" != "$folder" ] || kill -9 "$process"
done
wait_for "$job"
wait_for "$last"
cat slurm-*.out
"$program" --status shared
same_as_whole shared
