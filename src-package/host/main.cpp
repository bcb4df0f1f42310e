// SPDX-License-Identifier: GPL-2.0-or-later
// Takes what the stock executable takes; the styles come in through the shared object it is linked to.
#include <mpi.h>

#include "lammps.h"
#include "input.h"

int main(int argc, char **argv)
{
  MPI_Init(&argc, &argv);
  LAMMPS_NS::LAMMPS *host = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  host->input->file();
  delete host;
  MPI_Finalize();
  return 0;
}
