// SPDX-License-Identifier: GPL-2.0-or-later
// The fixes of one style, and the order in which the host calls fixes.
#ifndef BEARING_FIXES_H
#define BEARING_FIXES_H

#include "bearing_compat.h"

#include <vector>

namespace bearing {

// All fixes of class T, in the order of the deck: the same on all ranks.
template <class T> std::vector<T *> fixes_of(LAMMPS_NS::LAMMPS *lmp)
{
  std::vector<T *> list;
  for (int k = 0; k < lmp->modify->nfix; ++k)
    if (T *fix = dynamic_cast<T *>(lmp->modify->fix[k])) list.push_back(fix);
  return list;
}

// Name of a fix for messages: "fix ID style".
inline std::string name_of(const LAMMPS_NS::Fix &fix)
{
  return std::string("fix ") + fix.id + " " + fix.style;
}

// Error unless the host calls `first` before `second` in every hook that both have; `why` ends the
// message.
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

#endif
