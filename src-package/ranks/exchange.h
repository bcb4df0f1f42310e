// SPDX-License-Identifier: GPL-2.0-or-later
// All-to-all exchange of lists. The p-th list of the result is the list that rank p has for this
// rank.
#pragma once

#include <mpi.h>

#include <type_traits>
#include <vector>

namespace bearing {

template <class T>
std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>> &to, MPI_Comm world)
{
  static_assert(std::is_trivially_copyable<T>::value, "sent as bytes");
  const size_t np = to.size();
  if (np == 1) return to;
  std::vector<int> sent(np), got(np), sent_at(np, 0), got_at(np, 0);
  std::vector<T> out;
  for (size_t p = 0; p < np; ++p) {
    sent[p] = static_cast<int>(to[p].size() * sizeof(T));
    sent_at[p] = static_cast<int>(out.size() * sizeof(T));
    out.insert(out.end(), to[p].begin(), to[p].end());
  }
  MPI_Alltoall(sent.data(), 1, MPI_INT, got.data(), 1, MPI_INT, world);
  for (size_t p = 1; p < np; ++p) got_at[p] = got_at[p - 1] + got[p - 1];
  std::vector<T> in((got_at.back() + got.back()) / sizeof(T));
  MPI_Alltoallv(out.data(), sent.data(), sent_at.data(), MPI_BYTE, in.data(), got.data(),
                got_at.data(), MPI_BYTE, world);
  std::vector<std::vector<T>> from(np);
  for (size_t p = 0; p < np; ++p) {
    const auto first = in.begin() + got_at[p] / sizeof(T);
    from[p].assign(first, first + got[p] / sizeof(T));
  }
  return from;
}

}    // namespace bearing
