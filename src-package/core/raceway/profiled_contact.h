// SPDX-License-Identifier: GPL-2.0-or-later
// A contact in which the raceway, the ball or both have a profile. The contact law uses the overlap
// reduced by the profile. Because the depth changes along the raceway, the normal force acts on the
// ball's centre along the gradient of the stored energy, G = n - slope t.
#pragma once

#include "../geometry/ball_profile.h"
#include "kinematics.h"

namespace raceway {

template <class T> struct alignas(sizeof(T)) ProfiledContactT {
  T overlap = T();    // m, after subtracting the profile
  T slope = T();      // slope of the depth along the path of the ball's centre
  T bend = T();       // 1/m, derivative of the slope along the path; only for profiles that extend
                      // across the whole groove
  // For a pit: energy (J) in addition to that of the overlap; derivative of the overlap with
  // respect to the approach, minus 1; stiffness (N/m) that couples approach and path; stiffness
  // (N/m) along the path
  T energy = T(), follows = T(), cross = T(), side = T();
};
using ProfiledContact = ProfiledContactT<double>;

// Evaluates a contact on a raceway with a profile. `azimuth` (rad) is in the ring's frame; the
// ball's centre is r (m) from the ring's axis.
inline ProfiledContact profiled(const RacewayProfile &profile, const Raceway &p, double azimuth,
                                double r, double overlap)
{
  const CurveAt wide = profile.across(azimuth);
  const double d = overlap - wide.value;
  ProfiledContact c;
  c.overlap = d;
  c.slope = wide.slope / r;
  c.bend = wide.bend / (r * r);
  const NotchPath *pit = profile.pit(azimuth);
  if (!pit) return c;
  const CurveAt deep = pit->at(pit->from_middle(azimuth));
  const double x = 0.5 * pit->shape().width / profile.ellipse(), e = x * x;
  if (!(d > 0.0)) {
    c.overlap = d - std::fmin(deep.value, e);
    return c;
  }
  const PitLoad q = pit_load(d, deep.value, e);
  if (!(q.load > 0.0)) {
    c.overlap = d - std::fmin(deep.value, e);
    c.slope += deep.value < e ? deep.slope / r : 0.0;
    return c;
  }
  const double K = p.law.radial().K, flat = wide.slope / r, steep = deep.slope / r;
  c.overlap = std::pow(q.load, 2.0 / 3.0);
  c.slope = flat + steep * q.side / q.load;
  c.energy = K * (q.energy - 0.4 * c.overlap * q.load);
  c.follows = q.dd / (1.5 * std::sqrt(c.overlap)) - 1.0;
  c.cross = K * (q.dd * q.side / q.load + q.dD) * steep;
  c.side = K * (q.dd * (flat * flat - c.slope * c.slope) - 2.0 * q.dD * flat * steep +
                q.DD * steep * steep - q.side * deep.bend / (r * r)) +
           2.0 * c.slope * c.cross;
  return c;
}

// Does the same if the ball, the ring or both have a profile; `view` and b refer to the ball.
inline ProfiledContact profiled(const RacewayProfile *ring, const BallProfile *ball,
                                const Raceway &p, double azimuth, double r, double overlap,
                                const BallView &view, BallSlopes &b)
{
  const double d = ball ? ball->all_round(overlap, view, b) : overlap;
  ProfiledContact c;
  if (ring) c = profiled(*ring, p, azimuth, r, d);
  else c.overlap = d;
  if (ball) c.overlap = ball->pits(c.overlap, view, b, c.energy, c.follows);
  return c;
}

// Describes the rate of change of a quantity that depends on the direction of the normal in the
// ball's axes. Its coefficients are per unit of the velocity v of the ball's centre relative to the
// ring's material at that point, and per unit of the spin w of the ball relative to the ring.
// `along` and `across` are the derivatives of the quantity with respect to the direction.
template <class T> struct TurnRowT {
  Vec3T<T> v, w;

  RACEWAY_INLINE T rate(const BallStateT<T> &ball, const RingStateT<T> &ring,
                        const Vec3T<T> &from_ring) const
  {
    return dot(v, ball.v - ring.v - cross(ring.w, from_ring)) + dot(w, ball.w - ring.w);
  }
};

template <class T>
RACEWAY_INLINE TurnRowT<T> turn_row(const T &along, const T &across, const Vec3T<T> &e,
                                    const GroovePositionT<T> &c)
{
  const Vec3T<T> aside = e * c.nu - c.u * c.ne;
  return {c.t * T(along * c.nu / c.r) + aside * T(across / c.s), c.t * across - aside * along};
}

// Replaces the rate of approach (m/s) along n by the rate along G. v is the velocity of the ball's
// centre along t, relative to the ring's material at that point.
template <class T>
RACEWAY_INLINE T passing_speed(const BallStateT<T> &ball, const RingStateT<T> &ring,
                               const ContactStateT<T> &c)
{
  return dot(ball.v - ring.v, c.t) - (dot(ring.w, ring.e) * c.r - dot(ring.w, c.u) * c.z);
}

// Adds the effect of the slope to the forces of a contact, i.e. the normal force times (slope t).
// It acts at the ball's centre, which is at r u + z e from the ring's centre.
template <class T>
RACEWAY_INLINE void push_along(const T &slope, const Vec3T<T> &e, const ContactStateT<T> &c,
                               ContactForcesT<T> &f)
{
  const T push = c.normal * slope;
  f.force += c.t * push;
  f.ring_torque -= e * T(c.r * push) - c.u * T(c.z * push);
}

// Does the same for a ball's profile, using the row for the depth of the profile. d is the position
// of the ball's centre relative to the ring's centre.
template <class T>
RACEWAY_INLINE void push_along(const TurnRowT<T> &depth, const Vec3T<T> &d,
                               const ContactStateT<T> &c, ContactForcesT<T> &f)
{
  const Vec3T<T> force = depth.v * c.normal, torque = depth.w * c.normal;
  f.force += force;
  f.ball_torque += torque;
  f.ring_torque -= torque + cross(d, force);
}

}    // namespace raceway
