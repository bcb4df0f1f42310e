// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of lubricated contacts, the film not in the gap.
#include "raceway_contacts.h"

namespace raceway {

RACEWAY_WIDE bool BearingForces::lubricated_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<LubricatedLaws, false>(stage, failure);
}

}    // namespace raceway
