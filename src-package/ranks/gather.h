// SPDX-License-Identifier: GPL-2.0-or-later
// All ranks' vectors of plain structs, in rank order, on every rank.
#ifndef BEARING_GATHER_H
#define BEARING_GATHER_H

#include <mpi.h>

#include <type_traits>
#include <vector>

namespace bearing {

template <class T> std::vector<T> gather_all(const std::vector<T> &mine, MPI_Comm world)
{
  static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
  int np;
  MPI_Comm_size(world, &np);
  if (np == 1) return mine;
  const int bytes = static_cast<int>(mine.size() * sizeof(T));
  std::vector<int> count(np), offset(np);
  MPI_Allgather(&bytes, 1, MPI_INT, count.data(), 1, MPI_INT, world);
  int total = 0;
  for (int p = 0; p < np; ++p) {
    offset[p] = total;
    total += count[p];
  }
  std::vector<T> all(total / sizeof(T));
  MPI_Allgatherv(mine.data(), bytes, MPI_BYTE, all.data(), count.data(), offset.data(), MPI_BYTE,
                 world);
  return all;
}

// The same without a copy where there is one rank; `space` is used otherwise.
template <class T>
const std::vector<T> &gather_all(const std::vector<T> &mine, std::vector<T> &space, MPI_Comm world)
{
  int np;
  MPI_Comm_size(world, &np);
  if (np == 1) return mine;
  space = gather_all(mine, world);
  return space;
}

}    // namespace bearing

#endif
