#!/usr/bin/env bash
# One shard of a run, as a job of a Slurm array:
#
#     sbatch --array=0-15 runs/slurm.sh v1 scripted outputs/v1
#     probe merge outputs/v1/shard-* --out outputs/v1/whole
#
# The same command again goes on where jobs were cut off.
#SBATCH --job-name=probe
#SBATCH --cpus-per-task=2
#SBATCH --mem=6G
#SBATCH --time=04:00:00
#SBATCH --requeue
set -euo pipefail

suite=$1 agent=$2 out=$3
export OMP_NUM_THREADS=1
shard=$SLURM_ARRAY_TASK_ID
exec probe run "$suite" --agent "$agent" --shard "$shard/$SLURM_ARRAY_TASK_COUNT" \
    --workers "${SLURM_CPUS_PER_TASK:-1}" --out "$out/shard-$shard"
