// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles the contact loop with the laws of inputs/models/paper, dry and lubricated, inlined.
#include "raceway_contacts_fused.h"

namespace raceway {

RACEWAY_WIDE bool BearingForces::paper_raceways(const Stage &stage, Failure &failure)
{
  return fused<DryLaws, PaperLaws>(stage, failure);
}

}    // namespace raceway
