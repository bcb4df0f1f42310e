// SPDX-License-Identifier: GPL-2.0-or-later
// What contact_lanes.cpp does, for the files that compile it.
#ifndef RACEWAY_CONTACT_LANES_LAW_H
#define RACEWAY_CONTACT_LANES_LAW_H

#include "contact_lanes.h"
#include "lane_frame.h"
#include "lanes_apart.h"

#include <algorithm>

namespace raceway {

RACEWAY_INLINE Vec3L side_by_side(const double *const (&of)[lanes])
{
  const auto take = [&of](int k) __attribute__((always_inline)) {
    return Lane{of[0][k], of[1][k], of[2][k], of[3][k]};
  };
  return {take(0), take(1), take(2)};
}
RACEWAY_INLINE Vec3L in_all(const Vec3 &v)
{
  return {all_lanes(v.x), all_lanes(v.y), all_lanes(v.z)};
}

RACEWAY_INLINE Vec3L places(const ContactLanes &c)
{
  return side_by_side({c.ball[0].x, c.ball[1].x, c.ball[2].x, c.ball[3].x}) - in_all(c.groove.x);
}
RACEWAY_INLINE BallStateT<Lane> balls(const ContactLanes &c)
{
  return {places(c), side_by_side({c.ball[0].v, c.ball[1].v, c.ball[2].v, c.ball[3].v}),
          side_by_side({c.ball[0].w, c.ball[1].w, c.ball[2].w, c.ball[3].w})};
}
RACEWAY_INLINE RingStateT<Lane> rings(const ContactLanes &c)
{
  return {in_all(c.groove.x), in_all(c.groove.v), in_all(c.groove.w), in_all(c.groove.e)};
}

RACEWAY_INLINE LaneMask place(const RacewayPhysics &p, const Vec3L &d, const Vec3L &e,
                              ContactStateT<Lane> &c)
{
  locate(d, e, p.centre_circle, c);
  c.overlap = c.s - p.slack;
  return ~(c.overlap <= -p.reach);
}

template <class L> RACEWAY_INLINE void act_as(const RacewayPhysics &p, ContactLanes &x)
{
  const BallStateT<Lane> ball = balls(x);
  const RingStateT<Lane> ring = rings(x);
  ContactStateT<Lane> &c = x.all;
  LaneMask live = place(p, ball.x, ring.e, c);
  find_motions<L::couples>(p, ball, ring, c);
  const RacewayConstantsT<Lane> constants = p.law.at(c.cos_angle);
  const Lane overlap = c.overlap;
  if constexpr (L::decides) {
    live &= ~L::misses(p, constants, c);
    if (!any(live)) {
      std::fill(x.live, x.live + lanes, false);
      if (x.gaps) lanes_apart(c, x.state);
      return;
    }
    c.overlap = where(live, overlap, 1e-9);    // any that has a load
  }
  Lane before[L::states > 0 ? L::states : 1], after[L::states > 0 ? L::states : 1];
  for (int k = 0; k < L::states; ++k)
    before[k] = Lane{x.kept[0][k], x.kept[1][k], x.kept[2][k], x.kept[3][k]};
  L::act(p, constants, LawStates<Lane>{x.dt, before, after}, c);
  ContactForcesT<Lane> forces = assemble<L::couples>(p, ring.e, c);
  if (p.groove.offset != 0.0) from_groove(ring.e, p.groove.offset, forces);
  c.overlap = overlap;
  lanes_apart(c, x.state);
  lanes_apart(forces, x.force);
  for (int i = 0; i < lanes; ++i) x.live[i] = live[i];
  if (x.dt > 0.0)
    for (int k = 0; k < L::states; ++k)
      for (int i = 0; i < lanes; ++i) x.kept[i][k] = after[k][i];
}

// Of the law that the raceway has.
RACEWAY_INLINE void act_as_any(const RacewayPhysics &p, ContactLanes &x)
{
  with_law(p.parts, [&](auto law) __attribute__((always_inline)) { act_as<decltype(law)>(p, x); });
}

void act_in_narrow_lanes(const RacewayPhysics &, ContactLanes &);    // without AVX2

}    // namespace raceway

#endif
