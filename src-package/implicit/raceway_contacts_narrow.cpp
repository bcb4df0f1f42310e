// SPDX-License-Identifier: GPL-2.0-or-later
// Smooth raceways with any law, for processors without AVX2.
#include "../physics/targets.h"

#ifdef RACEWAY_TWO_TARGETS    // else the laws are in the other files
#define RACEWAY_ONE_TARGET 1
#include "raceway_contacts.h"

namespace raceway {

bool BearingForces::narrow_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<Laws, false>(stage, failure);
}

}    // namespace raceway
#endif
