// SPDX-License-Identifier: GPL-2.0-or-later
#include "../numbers/instruction_set.h"
#include "contact.h"
#include "contact_lanes_law.h"

namespace raceway {

RACEWAY_LANES void find_places(const RacewayPhysics &p, ContactLanes &x)
{
  ContactStateT<Lane> &c = x.all;
  const LaneMask live = place(p, places(x), in_all(x.groove.e), c);
  for (int i = 0; i < lanes; ++i) x.live[i] = live[i];
  if (!x.gaps || !any(~live)) return;
  find_motions<false>(p, balls(x), rings(x), c);
  lanes_apart(c, x.state);
}

static RACEWAY_WIDE bool act_fused(const RacewayPhysics &p, ContactLanes &x)
{
  const auto act = [&](auto law) __attribute__((always_inline)) { act_as(law, p, x); };
  return with_law(p.parts, DryLaws(), act) || with_law(p.parts, PaperLaws(), act) ||
         with_law(p.parts, FilmLaws(), act) || with_law(p.parts, FullLaws(), act);
}

static RACEWAY_WIDE void act_in_wide_lanes(const RacewayPhysics &p, ContactLanes &x)
{
  with_any_law(p.parts, wide_law,
               [&](const auto &law) __attribute__((always_inline)) { act_as(law, p, x); });
}

void act_by_parts(const RacewayPhysics &p, ContactLanes &x)
{
#ifdef RACEWAY_TWO_TARGETS
  if (!wide_lanes()) return act_in_narrow_lanes(p, x);
#endif
  act_in_wide_lanes(p, x);
}

void act_in_lanes(const RacewayPhysics &p, ContactLanes &x)
{
  if (!wide_lanes() || x.flawed || !act_fused(p, x)) act_by_parts(p, x);
}

}    // namespace raceway
