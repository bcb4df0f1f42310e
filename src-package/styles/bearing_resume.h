// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(bearing_resume,BearingResume)
// clang-format on
#else
#ifndef LMP_BEARING_RESUME_H
#define LMP_BEARING_RESUME_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

// bearing_resume FILE resume yes|no [overwrite yes|no]: creates and claims the folder of the
// restart file. It sets the host's variable b_resumed to 1 if the run continues from the restart
// file, and to 0 otherwise.
class BearingResume : public bearing::CommandBase {
 public:
  explicit BearingResume(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);
};

}    // namespace LAMMPS_NS

#endif
#endif
