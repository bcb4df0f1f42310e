// SPDX-License-Identifier: GPL-2.0-or-later
// Raceways of which some have a profile, with film in the gap.
#include "raceway_contacts.h"

namespace raceway {

bool BearingForces::flawed_gap_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<GapLaws, true>(stage, failure) || raceways_of<FullLaws, true>(stage, failure);
}

}    // namespace raceway
