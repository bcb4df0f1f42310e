// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_phase.h"

#include "bearing_compat.h"

using namespace LAMMPS_NS;

void bearing::WaitsForRun::refuse_plain_run(LAMMPS *lmp, const std::string &command) const
{
  if (lmp->modify->find_fix(fix_of_run) < 0)
    BRG_ALL_OF(lmp, command + ": without a number of steps it samples only during run_bearing, "
                              "not during run");
}
