// SPDX-License-Identifier: GPL-2.0-or-later
// Implementation of contact_lanes.cpp, included by the files that compile it for a particular
// instruction set.
#pragma once

#include "../numbers/lane_frame.h"
#include "../numbers/lanes_apart.h"
#include "any_law.h"
#include "contact_lanes.h"

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

// Computes the frame and the overlap. Returns the lanes that are within reach.
RACEWAY_INLINE LaneMask place(const RacewayPhysics &p, const Vec3L &d, const Vec3L &e,
                              ContactStateT<Lane> &c)
{
  locate(d, e, p.centre_circle, c);
  return ~out_of_reach(p, c);
}

// Profiles of up to four contacts.
struct LaneFlaws {
  LaneMask ring = {}, ball = {};
  Lane overlap, slope = {}, along = {}, across = {}, energy = {};

  RACEWAY_INLINE LaneFlaws(const ContactLanes &x, const Lane &smooth) : overlap(smooth)
  {
    for (int i = 0; i < lanes; ++i) {
      const FlawedPlace *const flaw = x.flaw[i];
      if (!flaw) continue;
      overlap[i] = flaw->on.overlap;
      energy[i] = flaw->on.energy;
      ring[i] = -flaw->ring;
      ball[i] = -flaw->ball;
      if (flaw->ring) slope[i] = flaw->on.slope;
      if (!flaw->ball) continue;
      along[i] = flaw->turned.along;
      across[i] = flaw->turned.across;
    }
  }
};
RACEWAY_INLINE void select(const LaneMask &yes, const ContactForcesT<Lane> &from,
                           ContactForcesT<Lane> &to)
{
  const Vec3L *const source[] = {&from.force, &from.ball_torque, &from.ring_torque};
  Vec3L *const target[] = {&to.force, &to.ball_torque, &to.ring_torque};
  for (int k = 0; k < 3; ++k)
    *target[k] = {where(yes, source[k]->x, target[k]->x), where(yes, source[k]->y, target[k]->y),
                  where(yes, source[k]->z, target[k]->z)};
}

template <class L>
RACEWAY_INLINE void act_as(const L &law, const RacewayPhysics &p, ContactLanes &x)
{
  const BallStateT<Lane> ball = balls(x);
  const RingStateT<Lane> ring = rings(x);
  ContactStateT<Lane> &c = x.all;
  LaneMask live = place(p, ball.x, ring.e, c);
  const bool flawed = L::takes_profiles && x.flawed;
  const LaneFlaws flaws(x, c.overlap);
  if (flawed) {
    c.overlap = flaws.overlap;
    live = ~(c.overlap <= -p.reach);
  }
  find_motions<L::couples>(p, ball, ring, c);
  const RacewayConstantsT<Lane> constants = p.law.at(c.cos_angle);
  const Lane overlap = c.overlap;
  if (law.decides) {
    live &= ~law.misses(p, constants, c);
    if (!any(live)) {
      std::fill(x.live, x.live + lanes, false);
      if (x.gaps) lanes_apart(c, x.state);
      return;
    }
    c.overlap = where(live, overlap, 1e-9);    // an arbitrary overlap at which there is a load
  }
  TurnRowT<Lane> depth;
  if (flawed) {
    const Lane rate = c.overlap_rate - flaws.slope * passing_speed(ball, ring, c);
    c.overlap_rate = where(flaws.ring, rate, c.overlap_rate);
    depth = turn_row(flaws.along, flaws.across, ring.e, c);
    const Lane turning = c.overlap_rate - depth.rate(ball, ring, ball.x);
    c.overlap_rate = where(flaws.ball, turning, c.overlap_rate);
  }
  Lane before[L::room], after[L::room];
  for (int k = 0; k < law.states; ++k)
    before[k] = Lane{x.kept[0][k], x.kept[1][k], x.kept[2][k], x.kept[3][k]};
  law.act(p, constants, LawStates<Lane>{x.dt, before, after}, c);
  ContactForcesT<Lane> forces = assemble<L::couples>(p, ring.e, c);
  if (flawed) {
    ContactForcesT<Lane> pushed = forces;
    push_along(flaws.slope, ring.e, c, pushed);
    select(flaws.ring, pushed, forces);
    pushed = forces;
    push_along(depth, ball.x, c, pushed);
    select(flaws.ball, pushed, forces);
  }
  if (p.groove.offset != 0.0) from_groove(ring.e, p.groove.offset, forces);
  if (x.energies) {
    Lane energy = law.energy(p, c);
    if (flawed) energy += flaws.energy;
    for (int i = 0; i < lanes; ++i) x.energy[i] = energy[i];
  }
  c.overlap = overlap;
  lanes_apart(c, x.state);
  lanes_apart(forces, x.force);
  for (int i = 0; i < lanes; ++i) x.live[i] = live[i];
  if (x.dt > 0.0)
    for (int k = 0; k < law.states; ++k)
      for (int i = 0; i < lanes; ++i) x.kept[i][k] = after[k][i];
}

void act_in_narrow_lanes(const RacewayPhysics &, ContactLanes &);    // without AVX2

}    // namespace raceway
