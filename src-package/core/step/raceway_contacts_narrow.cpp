// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles the contact loop for raceways with or without profiles for processors without AVX2.
#include "../numbers/lane.h"

#ifdef RACEWAY_TWO_TARGETS    // otherwise raceway_contacts_any.cpp covers the only target
#define RACEWAY_ONE_TARGET 1
#include "raceway_contacts.h"

namespace raceway {

Failure BearingForces::narrow_raceways(const Stage &stage)
{
  Failure failure = Failure::none;
  with_any_law(b_.model.parts, narrow_law,
               [&](const auto &law) { failure = raceways(law, stage); });
  return failure;
}

}    // namespace raceway
#endif
