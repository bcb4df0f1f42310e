// SPDX-License-Identifier: GPL-2.0-or-later
// Accepts the same arguments as the stock executable. The styles are provided by the shared object
// to which this program is linked.
#include <mpi.h>

#include "input.h"
#include "lammps.h"
#include "lone_start.h"

#include <cstdio>
#include <cstdlib>

// Returns true if this Open MPI program was started by the mpirun of MPICH, which may come from an
// activated .venv and would start independent processes of one rank each.
static bool started_by_mpich()
{
  int size;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const char *started = getenv("PMI_SIZE");
  return size == 1 && started && atoi(started) > 1;
}

int main(int argc, char **argv)
{
  LoneStart start;
  MPI_Init(&argc, &argv);
  start.forget();
  if (started_by_mpich()) {
    fprintf(stderr,
            "ERROR: %s uses Open MPI, but was started by the mpirun of MPICH: each of the %s "
            "processes would run the whole deck. "
            "Start it with mpirun.openmpi\n",
            argv[0], getenv("PMI_SIZE"));
    MPI_Finalize();
    return 1;
  }
  LAMMPS_NS::LAMMPS *host = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  host->input->file();
  delete host;
  MPI_Finalize();
  return 0;
}
