// SPDX-License-Identifier: GPL-2.0-or-later
// The class Command as declared by LAMMPS, which is missing in Debian's liblammps-dev of 29Sep2021.
#ifndef LMP_COMMAND_H
#define LMP_COMMAND_H

#include "pointers.h"

namespace LAMMPS_NS {

class Command : protected Pointers {
 public:
  Command(class LAMMPS *lmp) : Pointers(lmp) {}
  virtual void command(int, char **) = 0;
};

}    // namespace LAMMPS_NS

#endif
