// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_case,BearingCase)
// clang-format on
#else
#ifndef LMP_BEARING_CASE_H
#define LMP_BEARING_CASE_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_case NAME VALUE WORD "COMMAND" ... WORD "COMMAND" ...: run the commands that follow the
// WORD equal to VALUE; error if none matches. A command contains a blank, a word does not. Needed
// because the `if` of LIGGGHTS compares only numbers.
class BearingCase : public bearing::CommandBase {
 public:
  explicit BearingCase(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
