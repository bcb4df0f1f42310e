// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of film in the gap, damped as in the paper.
#include "raceway_contacts.h"

namespace raceway {

RACEWAY_WIDE bool BearingForces::gap_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<GapLaws, false>(stage, failure);
}

}    // namespace raceway
