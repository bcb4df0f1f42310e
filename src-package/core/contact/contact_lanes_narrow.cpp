// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts in lanes with any set of parts, compiled for processors without AVX2.
#include "../numbers/lane.h"

#ifdef RACEWAY_TWO_TARGETS    // otherwise contact_lanes.cpp covers the only target
#define RACEWAY_ONE_TARGET 1
#include "contact_lanes_law.h"

namespace raceway {

void act_in_narrow_lanes(const RacewayPhysics &p, ContactLanes &x)
{
  with_any_law(p.parts, narrow_law, [&](const auto &law) { act_as(law, p, x); });
}

}    // namespace raceway
#endif
