// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_variables,BearingVariables)
CommandStyle(bearing_given,BearingGiven)
CommandStyle(bearing_forget,BearingForget)
// clang-format on
#else
#ifndef LMP_DECK_VARIABLES_H
#define LMP_DECK_VARIABLES_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_variables FOLDER ...: stop with a message if -var sets a variable that neither the deck
// nor a file in a FOLDER uses. The host would accept it silently.
class BearingVariables : public bearing::CommandBase {
 public:
  explicit BearingVariables(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_given NAME TABLE ...: set the string variable NAME to the variables of the TABLEs given
// by -var, as name=value joined by commas, or none. It allows a run to be repeated.
class BearingGiven : public bearing::CommandBase {
 public:
  explicit BearingGiven(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

// bearing_forget FOLDER ...: delete the variables that the files in a FOLDER set, so that the next
// file can set its own.
class BearingForget : public bearing::CommandBase {
 public:
  explicit BearingForget(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
