// SPDX-License-Identifier: GPL-2.0-or-later
// The loop over contacts where raceways have profiles.
// Without forced inlining (physics/lane.h): with it, a compiler takes ten times as long.
#define RACEWAY_ONE_TARGET 1
#include "pair_bearing_forces.h"

using namespace LAMMPS_NS;

void PairBearingHertz::flawed_raceway_forces()
{
  raceway::with_law(law_, [this](auto law) { raceway_forces<decltype(law), true>(); });
}
