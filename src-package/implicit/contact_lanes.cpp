// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_lanes.h"

namespace raceway {

namespace {
template <class L> RACEWAY_INLINE void act_as(const RacewayPhysics &p, ContactLanes &x)
{
  ContactStateT<Lane> &c = x.state;
  locate(x.ball.x, x.ring.e, p.centre_circle, c);
  c.overlap = c.s - p.slack;
  const auto open = approach<L>(p, x.ball, x.ring, c);
  x.live = ~(c.overlap <= -p.reach);
  const Lane overlap = c.overlap;
  if constexpr (L::decides) {
    x.live &= ~open;
    c.overlap = where(x.live, overlap, 1e-9);    // any that has a load
  }
  L::act(p, p.law.at(c.cos_angle), LawStates<Lane>{x.dt, x.before, x.after}, c);
  x.forces = assemble<L::couples>(p, x.ring.e, c);
  c.overlap = overlap;
}
}    // namespace

RACEWAY_LANES void act_in_lanes(const RacewayPhysics &p, ContactLanes &x)
{
  with_law(p.parts, LawsInLanes(),
           [&](auto law) __attribute__((always_inline)) { act_as<decltype(law)>(p, x); });
}

}    // namespace raceway
