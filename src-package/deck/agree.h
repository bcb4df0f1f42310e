// SPDX-License-Identifier: GPL-2.0-or-later
// Broadcasts the result of a file check on rank 0 to all ranks.
#pragma once

#include <mpi.h>
#include <string>

namespace bearing {

// Returns the text of rank 0, which is empty if there is no error.
inline std::string agree(std::string complaint, MPI_Comm world)
{
  int n = static_cast<int>(complaint.size());
  MPI_Bcast(&n, 1, MPI_INT, 0, world);
  complaint.resize(n);
  if (n) MPI_Bcast(&complaint[0], n, MPI_CHAR, 0, world);
  return complaint;
}

}    // namespace bearing
