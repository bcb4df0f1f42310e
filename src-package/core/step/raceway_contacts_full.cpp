// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles the contact loop with the laws of inputs/models/film and full inlined.
#include "raceway_contacts_fused.h"

namespace raceway {

RACEWAY_WIDE bool BearingForces::full_raceways(const Stage &stage, Failure &failure)
{
  return fused<FilmLaws, FullLaws>(stage, failure);
}

}    // namespace raceway
