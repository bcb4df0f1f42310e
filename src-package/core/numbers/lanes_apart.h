// SPDX-License-Identifier: GPL-2.0-or-later
// Converts a struct of lanes to four structs of doubles, and back.
#pragma once

#include "lane.h"

#include <cstring>
#include <type_traits>

namespace raceway {

// Returns four lanes chosen from `a` (indices 0 to 3) and `b` (indices 4 to 7).
template <int i, int j, int k, int l> RACEWAY_INLINE Lane lanes_of(const Lane &a, const Lane &b)
{
#ifdef __clang__
  return __builtin_shufflevector(a, b, i, j, k, l);
#else
  return __builtin_shuffle(a, b, LaneMask{i, j, k, l});
#endif
}

// Transposes blocks of four numbers per lane.
template <class One, class Four>
RACEWAY_INLINE void lanes_apart(const Four &four, One *const (&to)[lanes])
{
  static_assert(sizeof(Four) == lanes * sizeof(One) && std::is_trivially_copyable<One>::value,
                "the same numbers in the same order");
  constexpr size_t numbers = sizeof(One) / sizeof(double);
  const char *from = reinterpret_cast<const char *>(&four);
  const auto lane = [from](size_t k) __attribute__((always_inline)) {
    Lane a;
    memcpy(&a, from + k * sizeof a, sizeof a);
    return a;
  };
  const auto put = [&to](int one, size_t k, const auto &a) __attribute__((always_inline)) {
    memcpy(reinterpret_cast<char *>(to[one]) + k * sizeof(double), &a, sizeof a);
  };
  constexpr size_t in_fours = numbers / lanes * lanes;
  for (size_t k = 0; k < in_fours; k += lanes) {
    const Lane a = lane(k), b = lane(k + 1), c = lane(k + 2), d = lane(k + 3);
    const Lane ab_02 = lanes_of<0, 4, 2, 6>(a, b), ab_13 = lanes_of<1, 5, 3, 7>(a, b),
               cd_02 = lanes_of<0, 4, 2, 6>(c, d), cd_13 = lanes_of<1, 5, 3, 7>(c, d);
    put(0, k, lanes_of<0, 1, 4, 5>(ab_02, cd_02));
    put(1, k, lanes_of<0, 1, 4, 5>(ab_13, cd_13));
    put(2, k, lanes_of<2, 3, 6, 7>(ab_02, cd_02));
    put(3, k, lanes_of<2, 3, 6, 7>(ab_13, cd_13));
  }
  for (size_t k = in_fours; k < numbers; ++k)
    for (int i = 0; i < lanes; ++i) put(i, k, double(lane(k)[i]));
}

}    // namespace raceway
