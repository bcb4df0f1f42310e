#!/bin/bash
# Run one deck on several ranks, from the root of the repository; this pays off if one box contains many bearings. Restarts work as in run.sh, which does the work:
#   sbatch --ntasks=8 inputs/cluster/mpi.sh build/run/mine -var passes 1000
# The run may continue on a different number of ranks; the results are bitwise identical.
#SBATCH --job-name=raceway
#SBATCH --ntasks=4
#SBATCH --time=04:00:00
#SBATCH --signal=B:TERM@120
#SBATCH --requeue
#SBATCH --open-mode=append
# Debian's mpirun starts the ranks on the nodes of the job. MPIRUN may name another launcher of the Open MPI that the program was built with.
export PROGRAM="${MPIRUN:-mpirun.openmpi} -np ${SLURM_NTASKS:?submit this with sbatch, or set SLURM_NTASKS} build/liggghts"
# Slurm runs a copy of this script, so run.sh is not in the same folder
exec bash inputs/cluster/run.sh "$@"
