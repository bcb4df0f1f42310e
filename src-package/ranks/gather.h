// SPDX-License-Identifier: GPL-2.0-or-later
// Gathers the vectors of plain structs from all ranks on every rank, in rank order.
#pragma once

#include <mpi.h>

#include <cstddef>
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

// Does the same, but without a copy if there is only one rank. Otherwise the result is stored in
// `space`.
template <class T>
const std::vector<T> &gather_all(const std::vector<T> &mine, std::vector<T> &space, MPI_Comm world)
{
  int np;
  MPI_Comm_size(world, &np);
  if (np == 1) return mine;
  space = gather_all(mine, world);
  return space;
}

// Gathers the numbers from all ranks into `all` on rank 0, in rank order. Returns the offset of
// each rank's numbers followed by the total on rank 0, and an empty vector on other ranks.
inline std::vector<size_t> gather_to_first(const std::vector<double> &mine,
                                           std::vector<double> &all, MPI_Comm world)
{
  int np, me;
  MPI_Comm_size(world, &np);
  MPI_Comm_rank(world, &me);
  const int n = static_cast<int>(mine.size());
  std::vector<int> count(np), at(np, 0);
  MPI_Gather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, 0, world);
  std::vector<size_t> begin;
  if (me == 0) {
    begin.assign(np + 1, 0);
    for (int p = 0; p < np; ++p) {
      at[p] = static_cast<int>(begin[p]);
      begin[p + 1] = begin[p] + count[p];
    }
    all.resize(begin[np]);
  }
  MPI_Gatherv(mine.data(), n, MPI_DOUBLE, all.data(), count.data(), at.data(), MPI_DOUBLE, 0,
              world);
  return begin;
}

}    // namespace bearing
