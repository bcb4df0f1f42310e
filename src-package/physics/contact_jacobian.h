// SPDX-License-Identifier: GPL-2.0-or-later
// How the force of a raceway on a ball changes with velocity and position: what an implicit step
// solves with.
//
// f = -N n - f_t t - f_w w at the contact point (contact.h), N = max(0, Q + C rate), friction by
// the smoothed Coulomb law f_t t + f_w w = mu N eps,  eps = s/sqrt(|s|^2 + v_0^2),  s = s_t t + s_w
// w. With V the velocity of ball surface against ring surface at the contact point and X the place
// of the ball against the groove:
//   D = -df/dV = C (n + mu eps) n + g (t t + w w),                      g = mu N/sqrt(|s|^2 +
//   v_0^2) K = -df/dX = k (n + mu eps) n + N/s_g w w + N nu/r t t
// (products of two vectors are dyads; C and k count only while N > 0; s_g is the distance of the
// ball from the circle of groove centres and r from the axis: the last two terms turn the normal as
// the ball moves across and along the groove). g is the secant of friction, f/s, where the tangent
// would add -g eps eps: the tangent of a sliding contact is nearly flat, and one correction then
// throws a light ball across zero sliding. Held fixed in both: C, mu and v_0 (hence film and
// entrainment), the constants' dependence on the contact angle, and the turn of t and w. They
// change the rate of Newton's method, not its result.
//
// hd D + hk K = push (n + mu eps) n + along t t + across w w; the ball's spin enters through the
// lever R n, for which n x t = w and n x w = -t.
#ifndef RACEWAY_CONTACT_JACOBIAN_H
#define RACEWAY_CONTACT_JACOBIAN_H

#include "contact.h"

namespace raceway {

template <class T> struct ContactJacobianT {
  Vec3T<T> n, t, w;         // normal (ball -> raceway), circumferential, and across the groove
  Vec3T<T> friction;        // mu eps
  T push, along, across;    // of hd D + hk K
  T damper, grip;           // of hd D: C and g

  // (hd D + hk K) q and q (hd D + hk K)
  RACEWAY_INLINE Vec3T<T> times(const Vec3T<T> &q) const
  {
    return (n + friction) * T(push * dot(n, q)) + t * T(along * dot(t, q)) +
           w * T(across * dot(w, q));
  }
  RACEWAY_INLINE Vec3T<T> before(const Vec3T<T> &q) const
  {
    return n * T(push * dot(n + friction, q)) + t * T(along * dot(t, q)) +
           w * T(across * dot(w, q));
  }
  // hd D q, and n x (q hd D)
  RACEWAY_INLINE Vec3T<T> damped(const Vec3T<T> &q) const
  {
    return (n + friction) * T(damper * dot(n, q)) + t * T(grip * dot(t, q)) +
           w * T(grip * dot(w, q));
  }
  RACEWAY_INLINE Vec3T<T> turned(const Vec3T<T> &q) const
  {
    return w * T(grip * dot(t, q)) - t * T(grip * dot(w, q));
  }
};

// Jacobian of a contact whose forces are known, 0 where `live` says so; e is the axis of the ring.
template <class T, class Test>
RACEWAY_INLINE ContactJacobianT<T> contact_jacobian(const ContactStateT<T> &c, const Vec3T<T> &e,
                                                    const Test &live, double hd, double hk)
{
  ContactJacobianT<T> j;
  const auto presses = live & (c.normal > 0.0);
  const T normal = where(presses, c.normal, 0.0), g = where(presses, c.ct, 0.0);
  j.n = c.u * c.nu + e * c.ne;
  j.t = c.t;
  j.w = e * c.nu - c.u * c.ne;
  const T inverse = where(presses, T(1.0 / c.normal), 0.0);
  j.friction = c.t * T(c.friction_t * inverse) + j.w * T(c.friction_w * inverse);
  j.damper = where(presses, T(hd * c.damping), 0.0);
  j.grip = hd * g;
  j.push = j.damper + where(presses, T(hk * c.stiffness), 0.0);
  j.along = j.grip + hk * normal * c.nu / c.r;
  j.across = j.grip + hk * normal / c.s;
  return j;
}

}    // namespace raceway

#endif
