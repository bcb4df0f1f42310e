// SPDX-License-Identifier: GPL-2.0-or-later
// Raceways of which some have a profile, without film in the gap.
// For one instruction set: inlined by force, as for several, these take a compiler minutes.
#define RACEWAY_ONE_TARGET 1
#include "raceway_contacts.h"

namespace raceway {

bool BearingForces::flawed_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<DryLaws, true>(stage, failure) ||
         raceways_of<LubricatedLaws, true>(stage, failure);
}

}    // namespace raceway
