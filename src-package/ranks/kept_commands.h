// SPDX-License-Identifier: GPL-2.0-or-later
// Commands kept in a restart file of the host, which replays them.
#ifndef BEARING_KEPT_COMMANDS_H
#define BEARING_KEPT_COMMANDS_H

#include <cstdio>
#include <mpi.h>
#include <string>
#include <vector>

namespace bearing {

using Commands = std::vector<std::vector<std::string>>;    // their words

void write_commands(FILE *, const Commands &);
// Rank 0 reads, all ranks return the same. False if the file ends early.
bool read_commands(FILE *, MPI_Comm, Commands &);

}    // namespace bearing

#endif
