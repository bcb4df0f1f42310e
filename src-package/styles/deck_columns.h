// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_dump,BearingDump)
// clang-format on
#else
#ifndef LMP_DECK_COLUMNS_H
#define LMP_DECK_COLUMNS_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_dump ID GROUP N FILE SOURCE [append yes|no] [columns NAME]: defines an output of the host
// that contains all columns of SOURCE. It is a dump if SOURCE is a compute, and a fix print if
// SOURCE is a fix. NAME is a variable in which the names of the columns are stored.
class BearingDump : public bearing::CommandBase {
 public:
  explicit BearingDump(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
