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

// bearing_case NAME VALUE WORD "COMMAND" ... WORD "COMMAND" ...: carry out the commands that follow
// the WORD that is VALUE; stop if there is none. A command has a blank, a word has not. LIGGGHTS
// compares numbers only in `if`.
class BearingCase : public bearing::CommandBase {
 public:
  explicit BearingCase(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
