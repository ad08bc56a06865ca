#!/bin/bash
# Runs what `endless cluster slurm` writes on a real Slurm: one controller and two nodes on this machine (Debian: slurm-wlm), as
# root. In the middle a task is told that its time is over, one node is drained and the other killed; both come back. The dataset
# must be that of one run, byte for byte.
#
#     scripts/judge_slurm.sh ENDLESS [WORK]
set -euo pipefail

endless=$(realpath "${1:?give the program: scripts/judge_slurm.sh ENDLESS [WORK]}")
work=$(realpath -m "${2:-$(mktemp -d)}")
[[ $(id -u) == 0 ]] || { echo "slurmd starts jobs as root only" >&2; exit 2; }
for program in munged slurmctld slurmd sbatch; do
    command -v "$program" >/dev/null || { echo "$program is missing: apt-get install slurm-wlm munge" >&2; exit 2; }
done
shards=8
port=${SLURM_TEST_PORT:-26817}
host=$(hostname -s)
mkdir -p "$work"/{state,munge,spool-node1,spool-node2}
cd "$work"
export SLURM_CONF=$work/slurm.conf
cat >slurm.conf <<CONF
ClusterName=judge
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CryptoType=crypto/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool-%n
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/%n.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=bf_interval=2,sched_interval=2
MpiDefault=none
ReturnToService=2
SlurmdTimeout=30
KillWait=5
JobRequeue=1
NodeName=node1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1 State=UNKNOWN
NodeName=node2 NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1 State=UNKNOWN
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
CONF

# Processes of jobs on a node, and those that look after them: by the environment that Slurm gave them.
pids_of_node() {
    local process environment parent
    for process in /proc/[0-9]*; do
        environment=$({ tr '\0' '\n' <"$process/environ"; } 2>/dev/null || true)
        [[ $'\n'$environment$'\n' == *$'\n'"SLURMD_NODENAME=$1"$'\n'* ]] || continue
        [[ $'\n'$environment$'\n' == *$'\n'"SLURM_CONF=$SLURM_CONF"$'\n'* ]] || continue
        echo "${process#/proc/}"
        parent=$({ awk '/^PPid:/ { print $2 }' "$process/status"; } 2>/dev/null || true)
        if [[ -n $parent ]] && grep -qs slurmstepd "/proc/$parent/comm"; then echo "$parent"; fi
    done | sort -u
}
end_all() {
    local file
    for file in node1.pid node2.pid slurmctld.pid munge/pid; do
        [[ -s $file ]] && kill "$(cat "$file")" 2>/dev/null
    done
    pids_of_node node1 | xargs -r kill -9 2>/dev/null
    pids_of_node node2 | xargs -r kill -9 2>/dev/null
    true
}
trap end_all EXIT
wait_for() { # SECONDS WHAT COMMAND...
    local limit=$((SECONDS + $1)) what=$2
    shift 2
    until "$@"; do
        if ((SECONDS > limit)); then
            echo "failed: waited too long for $what" >&2
            sinfo -N -l >&2 || true
            squeue -a >&2 || true
            exit 1
        fi
        sleep 0.5
    done
}

chmod 700 munge
head -c 1024 /dev/urandom >munge/key
chmod 400 munge/key
munged --force --socket="$work/munge/socket" --key-file="$work/munge/key" --pid-file="$work/munge/pid" \
    --log-file="$work/munge/log" --seed-file="$work/munge/seed"
slurmctld -c
slurmd -N node1
slurmd -N node2
idle() { [[ $(sinfo -h -N -o %t 2>/dev/null | grep -c '^idle$') == 2 ]]; }
wait_for 60 "two nodes" idle
sinfo -N

cat >recipe.toml <<'RECIPE'
videos = 12
maps = ["Town01", "Town02"]
size = "160x90"
fps = 10
duration = 15.0
cameras_per_scene = 1
vehicles = 5
pedestrians = 5
RECIPE
"$endless" generate whole --config recipe.toml 2>/dev/null
"$endless" cluster slurm recipe.toml --out out --shards $shards --cpus 1 --time 30 --program "$endless" >job.sh
bash job.sh

running_on() { [[ -n $(squeue -h -t R -w "$1" -o %i) ]]; }
task_on() { squeue -h -r -t R -w "$1" -o %A | head -1; }
begun() { [[ -n $(find out/videos -name '*.png' -print -quit 2>/dev/null) ]]; }
wait_for 120 "work on node1" running_on node1
wait_for 120 "work on node2" running_on node2
wait_for 240 "the first picture" begun

task=$(task_on node1)
echo "the time of job $task on node1 is over"
timeout 5 scancel --signal=USR1 --batch "$task" || true # it asks again and again when the job has ended meanwhile
wait_for 120 "the next work on node1" running_on node1

task=$(task_on node1)
echo "node1 is drained, and job $task taken off it"
scontrol update NodeName=node1 State=DRAIN Reason=judge
scontrol requeue "$task"

wait_for 120 "work on node2" running_on node2
echo "node2 dies with job $(task_on node2)"
kill -9 "$(cat node2.pid)"
pids_of_node node2 | xargs -r kill -9
scontrol update NodeName=node2 State=DOWN Reason=judge

sleep 2
echo "both come back"
squeue -a -r
scontrol update NodeName=node1 State=RESUME
slurmd -N node2
# It may have come back by itself.
back() {
    scontrol update NodeName=node2 State=RESUME 2>/dev/null || [[ $(sinfo -h -n node2 -o %t) =~ ^(idle|mix|alloc)$ ]]
}
wait_for 60 "node2" back

ended() { [[ -z $(squeue -h) ]]; }
wait_for 900 "the end" ended
cat endless-check-*.log
grep -q "all is well" endless-check-*.log
again=$(grep -c "videos to make\|nothing to do" endless-[0-9]*.log | awk -F: '$2 > 1' | wc -l)
diff -r out whole
echo "the same bytes as one run; $again of $shards shards were begun more than once"
[[ $again -ge 2 ]]
