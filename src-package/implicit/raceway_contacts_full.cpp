// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of film in the gap, damped by the film's branch.
#include "raceway_contacts.h"

namespace raceway {

RACEWAY_WIDE bool BearingForces::full_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<FullLaws, false>(stage, failure);
}

}    // namespace raceway
