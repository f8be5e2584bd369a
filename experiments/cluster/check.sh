#!/usr/bin/env bash
# Runs the quick profile as 16 shards by Slurm and by HyperQueue, with a task and workers killed on the way, and holds
# what `merge` makes of them against one run.
#
#     bash experiments/cluster/check.sh PROGRAM RUN [FOLDER]
#
# For machines that are thrown away: it installs what is missing, makes a key of munge, and starts and ends daemons.
# PROGRAM is zonobench, RUN a folder that its `reproduce` wrote. On Debian, Slurm and munge are installed where they are
# missing, HyperQueue from PyPI; an engine that cannot be had or does not start is skipped, loudly.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
program=$(realpath "$1")
one=$(realpath "$2")
work=$(realpath "${3:-$(mktemp -d)}")
mkdir -p "$work"
export ZONOBENCH=$program PROFILE=${PROFILE:-quick}
started=()
trap 'for process in ${started[@]+"${started[@]}"}; do kill "$process" 2>/dev/null || true; done' EXIT
skipped() { printf '\n*** SKIPPED: %s ***\n\n' "$1"; }

deterministic() { grep -B2 '"deterministic": true' "$1/manifest.json" | grep -E '"(path|sha256)"'; }
same_bytes() {
  "$program" merge "$1" --out "$1-merged" >"$1-merge.log" || { cat "$1-merge.log"; return 1; }
  diff <(deterministic "$one") <(deterministic "$1-merged") && echo "$2: 16 shards have the bytes of one run"
}
# The process that makes a shard in a folder.
being_made() { pgrep -f -- "reproduce .*--out $1( |$)" | head -n 1; }
wait_for() { for _ in $(seq 600); do "$@" >/dev/null 2>&1 && return; sleep 0.1; done; echo "waited in vain: $*"; return 1; }

by_slurm() {
  local out=$work/slurm conf=$work/slurm.conf memory
  memory=$(awk '/^MemAvailable/ { print int($2 / 1024) }' /proc/meminfo)
  mkdir -p "$work/state" "$work/spool" /run/munge
  [ -s /etc/munge/munge.key ] || mungekey --create
  chown munge: /etc/munge/munge.key /run/munge
  if ! pgrep -x munged >/dev/null; then
    runuser -u munge -- munged
    started+=("$(cat /run/munge/munged.pid)")
  fi
  cat >"$conf" <<END
ClusterName=check
SlurmctldHost=$(hostname)
SlurmUser=root
AuthType=auth/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
ReturnToService=2
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmdPidFile=$work/slurmd.pid
SlurmctldPidFile=$work/slurmctld.pid
NodeName=$(hostname) CPUs=$(nproc) RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
END
  export SLURM_CONF=$conf
  slurmctld -D -i -f "$conf" >"$work/slurmctld.log" 2>&1 &
  started+=($!)
  slurmd -D -f "$conf" >"$work/slurmd.log" 2>&1 &
  started+=($!)
  if ! wait_for bash -c "sinfo --noheader --format=%T | grep -E 'idle|mixed'"; then
    tail -n 5 "$work/slurmctld.log" "$work/slurmd.log"
    skipped 'Slurm does not start on this machine, so nobody has tried the array'
    return
  fi
  local submit=(sbatch --parsable --chdir="$work" --export="ALL,OUT=$out" --array=0-15)
  "${submit[@]}" --wait "$here/slurm.sh" >"$work/first.log" &
  local first=$!
  wait_for being_made "$out"
  kill -KILL "$(being_made "$out")"
  wait "$first" && { echo "a task was killed, and the array knows nothing of it"; return 1; }
  [ "$(find "$out" -name '*.shard' | wc -l)" = 15 ] || { echo "15 shards are left of 16"; ls "$out"; return 1; }
  "${submit[@]}" --wait "$here/slurm.sh" >"$work/second.log"
  same_bytes "$out" "Slurm, a task killed and the array submitted again"
}

by_hyperqueue() {
  export OUT=$work/hyperqueue SHARDS=16 WORKERS=2
  "$1" "$here/hyperqueue_shards.py" >"$work/killed.log" 2>&1 &
  local killed=$!
  wait_for bash -c "ls '$OUT'/*.shard"
  kill -KILL "$killed"
  # Tasks that outlive their worker would still be at their shards.
  wait_for bash -c "! pgrep -f -- 'reproduc[e] .*--out $OUT'"
  "$1" "$here/hyperqueue_shards.py" >"$work/job.log" 2>&1 || { cat "$work/job.log"; return 1; }
  same_bytes "$OUT" "HyperQueue, its workers killed midway and the job submitted again"
}

if command -v slurmctld >/dev/null || { apt-get update && apt-get install -y --no-install-recommends slurm-wlm munge; } \
  >"$work/apt.log" 2>&1; then
  by_slurm
else
  skipped 'Slurm cannot be installed, so nobody has tried the array'
fi
if python3 -m venv "$work/environment" >"$work/pip.log" 2>&1 &&
  "$work/environment/bin/pip" install hyperqueue >>"$work/pip.log" 2>&1; then
  by_hyperqueue "$work/environment/bin/python"
else
  skipped 'HyperQueue cannot be installed, so nobody has tried its job'
fi
