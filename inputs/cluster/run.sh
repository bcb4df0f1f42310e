#!/bin/bash
# Run one deck on one core, from the root of the repository:
#   sbatch inputs/cluster/run.sh build/run/mine -var load 5000 -var rpm 1000 -var passes 1000
# Words after the folder are passed to the deck. A restart file is written every KEEP samples and when Slurm sends the signal, two minutes before
# the time limit or when the job is cancelled or preempted. The job then requeues itself and continues; the results are bitwise identical.
#SBATCH --job-name=raceway
#SBATCH --ntasks=1
#SBATCH --time=04:00:00
#SBATCH --signal=B:TERM@120
#SBATCH --requeue
#SBATCH --open-mode=append
out=${1:?usage: run.sh FOLDER [-var NAME VALUE ...]}
shift
program=${PROGRAM:-build/liggghts}

# the run was finished by an earlier start of this job
if grep -qs '^wall_s' "$out/run.yaml"; then exit 0; fi

# the shell receives the signal and forwards it; USR1 has the same effect on the program as TERM, and mpirun forwards it unchanged
# shellcheck disable=SC2086
$program -in "${DECK:-inputs/in.6208}" -log none -var out "$out" -var keep "${KEEP:-1000}" -var resume yes "$@" &
run=$!
trap 'kill -USR1 $run' TERM INT USR1
wait $run
code=$?
if kill -0 $run 2>/dev/null; then wait $run; code=$?; fi    # the first wait was ended by the signal
trap - TERM INT USR1

# 138: the run was stopped by the signal and has written a restart file
if [ $code = 138 ] && [ -n "${SLURM_JOB_ID:-}" ] && command -v scontrol >/dev/null; then scontrol requeue "$SLURM_JOB_ID"; fi
exit $code
