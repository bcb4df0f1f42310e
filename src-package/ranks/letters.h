// SPDX-License-Identifier: GPL-2.0-or-later
// Point-to-point messages. A letter consists of a rank and a text, which is a list of numbers.
// Ranks without letters do not wait.
#pragma once

#include <mpi.h>

#include <vector>

namespace bearing {

// Sends the letters `from` and receives the letters `to`. The length of each text must be known on
// both sides.
template <class Letter>
void deliver(std::vector<Letter> &from, std::vector<Letter> &to, int message, MPI_Comm world)
{
  if (from.empty() && to.empty()) return;
  std::vector<MPI_Request> under_way;
  for (Letter &l : to) {
    under_way.emplace_back();
    MPI_Irecv(l.text.data(), static_cast<int>(l.text.size()), MPI_DOUBLE, l.rank, message, world,
              &under_way.back());
  }
  for (Letter &l : from) {
    under_way.emplace_back();
    MPI_Isend(l.text.data(), static_cast<int>(l.text.size()), MPI_DOUBLE, l.rank, message, world,
              &under_way.back());
  }
  MPI_Waitall(static_cast<int>(under_way.size()), under_way.data(), MPI_STATUSES_IGNORE);
}

}    // namespace bearing
