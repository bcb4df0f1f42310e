// SPDX-License-Identifier: GPL-2.0-or-later
// Compiles the contact loop for raceways with or without profiles and any set of parts.
#include "raceway_contacts.h"

namespace raceway {

RACEWAY_WIDE Failure BearingForces::any_raceways(const Stage &stage)
{
  Failure failure = Failure::none;
  with_any_law(b_.model.parts, wide_law, [&](const auto &law) __attribute__((always_inline)) {
    failure = raceways(law, stage);
  });
  return failure;
}

}    // namespace raceway
