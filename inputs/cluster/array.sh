#!/bin/bash
# Run the rows of a table as a job array, from the root of the repository:
#   sbatch --array=1-20 inputs/cluster/array.sh table.csv build/sweep/mine
# Task I of N runs the rows I, I+N, ..., as many at a time as it has cores. Submit it again to run the missing points;
# `raceway gather build/sweep/mine` shows which points exist. `raceway sweep table.csv --slurm job.sh` writes such a script for one table.
#SBATCH --job-name=raceway-sweep
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --time=01:00:00
#SBATCH --signal=TERM@60
table=${1:?usage: array.sh TABLE FOLDER}
out=${2:?usage: array.sh TABLE FOLDER}
exec "${RACEWAY:-.venv/bin/raceway}" sweep "$table" --out "$out" --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --part "${SLURM_ARRAY_TASK_ID:?submit this with sbatch --array=1-N}/${SLURM_ARRAY_TASK_COUNT:?}"
