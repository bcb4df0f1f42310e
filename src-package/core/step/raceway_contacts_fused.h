// SPDX-License-Identifier: GPL-2.0-or-later
// The loop over contacts with the laws inlined. Only the source files that compile it include this
// file.
#pragma once

#include "../contact/contact.h"
#include "raceway_contacts.h"

namespace raceway {

template <class... Families>
RACEWAY_INLINE bool BearingForces::fused(const Stage &stage, Failure &failure)
{
  const auto loop = [&](auto law) __attribute__((always_inline)) {
    using L = decltype(law);
    if constexpr (!L::explicit_step) failure = raceways(L(), stage);
  };
  return (with_law(b_.model.parts, Families(), loop) || ...);
}

}    // namespace raceway
