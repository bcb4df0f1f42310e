// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts of one raceway, four at a time, at given motions and without derivatives: what an
// explicit step asks for. For laws that cost more than what it takes to put contacts side by side.
// A lane has the bits that a contact alone has.
#ifndef RACEWAY_CONTACT_LANES_H
#define RACEWAY_CONTACT_LANES_H

#include "../physics/contact.h"

namespace raceway {

using LawsInLanes =
    LawList<RollingFriction<LubricatedLaw>, RollingFriction<GapLaw>, RollingFriction<FullLaw>,
            FullLaw<MixedFrictionPart, SlipSlicesPart, HydrodynamicRollingPart,
                    RollingHysteresisPart, DragPart>,
            LubricatedLaw<StribeckFrictionPart, SmoothedFrictionPart>,
            DryLaw<ConstantFrictionPart, SmoothedFrictionPart>>;

namespace detail {
template <class... L> constexpr bool among(unsigned parts, LawList<L...>)
{
  return ((L::parts == parts) || ...);
}
}    // namespace detail
template <class L> constexpr bool in_lanes = detail::among(L::parts, LawsInLanes());

// Set by whoever has contacts: ball with its place from the ring's centre, ring, and what the law
// keeps. Lanes that are not used may be anything that could touch: those of another contact.
struct ContactLanes {
  BallStateT<Lane> ball;
  RingStateT<Lane> ring;
  Lane before[most_states];
  double dt = 0.0;

  // found; what the law does not set stays as it is
  LaneMask live;    // they touch
  ContactStateT<Lane> state;
  ContactForcesT<Lane> forces;
  Lane after[most_states];
};

// Pre-condition: the law is one of LawsInLanes.
void act_in_lanes(const RacewayPhysics &p, ContactLanes &contacts);

}    // namespace raceway

#endif
