// SPDX-License-Identifier: GPL-2.0-or-later
// Accepts the same arguments as the stock executable, or the single argument -serve (run_server.h).
// The styles are provided by the shared object to which this program is linked.
#include <mpi.h>

#include "../deck/given_variables.h"
#include "input.h"
#include "lammps.h"
#include "lone_start.h"
#include "run_server.h"

#include <cstdio>
#include <cstdlib>

// True in a copy of a server. MPI was started by the server and is ended there: MPI's threads do
// not exist in the copy.
static bool is_copy = false;

int MPI_Finalize() { return is_copy ? MPI_SUCCESS : PMPI_Finalize(); }

int MPI_Abort(MPI_Comm world, int code)
{
  fflush(nullptr);    // Open MPI ends the process without writing its message
  if (!is_copy) return PMPI_Abort(world, code);
  _exit(code);
}

// Returns true if this Open MPI program was started by the mpirun of MPICH, which may come from an
// activated .venv and would start independent processes of one rank each.
static bool started_by_mpich()
{
  int size;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const char *started = getenv("PMI_SIZE");
  return size == 1 && started && atoi(started) > 1;
}

// The first grid of processes makes Open MPI load libraries, which all copies then share.
static void open_topologies()
{
  const int processes = 1, periodic = 0;
  MPI_Comm grid;
  MPI_Cart_create(MPI_COMM_SELF, 1, &processes, &periodic, 0, &grid);
  MPI_Comm_free(&grid);
}

int main(int argc, char **argv)
{
  LoneStart start;
  const bool serves = argc == 2 && strcmp(argv[1], "-serve") == 0;
  if (serves && !start.alone()) return 1;    // a launcher expects the processes that it started
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
  std::vector<std::string> words;
  std::vector<char *> arguments;
  if (serves) {
    open_topologies();
    is_copy = RunServer().next(words);
    if (!is_copy) {
      MPI_Finalize();
      return 0;
    }
    for (std::string &word : words) arguments.push_back(&word[0]);
    argc = static_cast<int>(arguments.size());
    argv = arguments.data();
    raceway_set_command_line(argc, argv);
  }
  LAMMPS_NS::LAMMPS *host = new LAMMPS_NS::LAMMPS(argc, argv, MPI_COMM_WORLD);
  host->input->file();
  delete host;
  MPI_Finalize();
  if (is_copy) {
    fflush(nullptr);
    _exit(0);
  }
  return 0;
}
