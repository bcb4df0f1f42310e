// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_columns,BearingColumns)
CommandStyle(bearing_dump,BearingDump)
// clang-format on
#else
#ifndef LMP_DECK_COLUMNS_H
#define LMP_DECK_COLUMNS_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_columns ID [STEM]: for a dump of the compute ID, set the string variables STEM_columns to
// the names of its columns, STEM_values to the words c_ID[1] c_ID[2] ... and STEM_format to their
// format. Names and format are quoted, so that each is one word. For `fix print` of a fix:
// STEM_columns is a title and STEM_values a line, with step and time first.
class BearingColumns : public bearing::CommandBase {
 public:
  explicit BearingColumns(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_dump ID GROUP N FILE SOURCE [append yes|no] [columns NAME]: the host's dump of all
// columns of the compute SOURCE, or fix print of those of the fix SOURCE. NAME is a variable for
// their names.
class BearingDump : public bearing::CommandBase {
 public:
  explicit BearingDump(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
