// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_derive,BearingDerive)
// clang-format on
#else
#ifndef LMP_BEARING_DERIVE_H
#define LMP_BEARING_DERIVE_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_derive LAW: set variables of the deck from others by a law. Values that the user gave are
// kept.
class BearingDerive : public bearing::CommandBase {
 public:
  explicit BearingDerive(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
