#!/usr/bin/env bash
#SBATCH --job-name=zonotopes
#SBATCH --array=0-15
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=2G
# A task of the array does a shard; sbatch --array=0-99 makes a hundred of them. SHARDS says how many there are where
# the array is a part of them, and options of `reproduce` follow the name of this script.
set -euo pipefail
"${ZONOBENCH:?the path of the program}" reproduce --profile "${PROFILE:-full}" --threads "${SLURM_CPUS_PER_TASK:-1}" \
  --shard "$SLURM_ARRAY_TASK_ID/${SHARDS:-$SLURM_ARRAY_TASK_COUNT}" --out "${OUT:?the folder of the shards}" "$@"
