// SPDX-License-Identifier: GPL-2.0-or-later
#include "run_phase.h"

#include "fix_bearing_run.h"
#include "fixes.h"

using namespace LAMMPS_NS;

void bearing::WaitsForRun::refuse_plain_run(LAMMPS *lmp, const std::string &command) const
{
  if (fixes_of<FixBearingRun>(lmp).empty())
    BRG_ALL_OF(lmp, command + ": without a number of steps it samples in run_bearing, not in run");
}
