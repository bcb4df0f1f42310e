// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the fixes of one style and checks the order in which the host calls fixes.
#pragma once

#include "bearing_compat.h"

#include <vector>

namespace bearing {

// Returns all fixes of class T in the order of the deck, which is the same on all ranks.
template <class T> std::vector<T *> fixes_of(LAMMPS_NS::LAMMPS *lmp)
{
  std::vector<T *> list;
  for (int k = 0; k < lmp->modify->nfix; ++k)
    if (T *fix = dynamic_cast<T *>(lmp->modify->fix[k])) list.push_back(fix);
  return list;
}

// Returns the name of a fix for messages, "fix ID style".
inline std::string name_of(const LAMMPS_NS::Fix &fix)
{
  return std::string("fix ") + fix.id + " " + fix.style;
}

// Makes a fix provide a scalar and, unless n is 0, a vector of n values, none of which grows with
// the system.
inline void provide_values(LAMMPS_NS::Fix &fix, int n, int every = 1)
{
  fix.scalar_flag = 1;
  fix.vector_flag = n > 0 ? 1 : 0;
  fix.size_vector = n;
  fix.extscalar = fix.extvector = 0;
  fix.global_freq = every;
}

// Stops with an error unless the host calls `first` before `second` in every hook that both have.
// The message ends with `why`.
inline void require_order(LAMMPS_NS::LAMMPS *lmp, const LAMMPS_NS::Fix &first,
                          const LAMMPS_NS::Fix &second, const std::string &why)
{
  for (int k = 0; k < lmp->modify->nfix; ++k) {
    if (lmp->modify->fix[k] == &first) return;
    if (lmp->modify->fix[k] == &second)
      BRG_ALL_OF(lmp,
                 name_of(first) + " must come before " + name_of(second) + " in the deck: " + why);
  }
}

}    // namespace bearing
