// SPDX-License-Identifier: GPL-2.0-or-later
// Defines the group of a fix. The host's command `group` only adds atoms, so a group would keep
// those of an earlier fix with the same ID, and `intersect` does not remove atoms from a group.
#pragma once

#include "bearing_compat.h"

#include <string>
#include <vector>

namespace bearing {

// Makes `name` the group of all atoms i for which has(i) is true, and returns its index.
template <class Has> int own_group(LAMMPS_NS::LAMMPS *lmp, const std::string &name, const Has &has)
{
  LAMMPS_NS::Atom &atom = *lmp->atom;
  std::vector<int> flags(atom.nlocal + 1, 0);
  for (int i = 0; i < atom.nlocal; ++i) flags[i] = has(i);
  if (const int old = lmp->group->find(name.c_str()); old >= 0)
    for (int i = 0; i < atom.nlocal; ++i) atom.mask[i] &= ~lmp->group->bitmask[old];
  lmp->group->create(name.c_str(), flags.data());
  return lmp->group->find(name.c_str());
}

}    // namespace bearing
