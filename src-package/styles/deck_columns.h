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

// bearing_dump ID GROUP N FILE SOURCE [append yes|no] [columns NAME]: defines a dump of the host
// with all columns of SOURCE if it is a compute, or a fix print with all columns if it is a fix.
// NAME is a variable that receives the names of the columns.
class BearingDump : public bearing::CommandBase {
 public:
  explicit BearingDump(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
