// SPDX-License-Identifier: GPL-2.0-or-later
// Laws of dry contacts.
#include "raceway_contacts.h"

namespace raceway {

RACEWAY_WIDE bool BearingForces::dry_raceways(const Stage &stage, Failure &failure)
{
  return raceways_of<DryLaws, false>(stage, failure);
}

}    // namespace raceway
