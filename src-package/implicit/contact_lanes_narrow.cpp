// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts in lanes for processors without AVX2.
#include "../physics/targets.h"

#ifdef RACEWAY_TWO_TARGETS    // else the laws are in contact_lanes.cpp
#define RACEWAY_ONE_TARGET 1
#include "contact_lanes_law.h"

namespace raceway {

void act_in_narrow_lanes(const RacewayPhysics &p, ContactLanes &x) { act_as_any(p, x); }

}    // namespace raceway
#endif
