// SPDX-License-Identifier: GPL-2.0-or-later
// Commands that are stored in a restart file of the host and repeated when it is read.
#pragma once

#include <cstdio>
#include <mpi.h>
#include <string>
#include <vector>

namespace bearing {

// Layout of the package's data in restart files. The number must be increased whenever the data
// written by any class change. Files written by builds before layout 2 contain no number.
constexpr int RESTART_LAYOUT = 9;

constexpr const char *CUT_OR_DAMAGED = "the restart file ends early or is damaged";

using Commands = std::vector<std::vector<std::string>>;    // words of each command

void write_commands(FILE *, const Commands &);
// Reads the file on rank 0. All ranks return the same text, which is empty or states what is wrong
// with the file.
std::string read_commands(FILE *, MPI_Comm, Commands &);

}    // namespace bearing
