// SPDX-License-Identifier: GPL-2.0-or-later
// Converts the motion of a ball and a ring to the local motions at their contact, and the local
// forces back to forces and torques. This does not depend on the contact law (law.h).
//
// The contact point lies at the distance R_b from the ball centre along the normal; both bodies are
// treated as rigid there. The force of the raceway on the ball is -N n - f_t t - f_w w (frame of
// groove.h). The opposite force acts on the ring at the same point, so linear and angular momentum
// are conserved to rounding.
//
// Entrainment speed (docs/theory, Film): half the sum of both surface velocities relative to the
// moving contact point, along t. The contact point rc u + zc e rotates about the ring axis together
// with the ball centre, at the speed phi' = ((v_b - v_r).t + z W.u)/r, and tilts with the axis:
//   u'.t = phi', e'.t = -W.u.
#pragma once

#include "contact_state.h"
#include "raceway.h"

namespace raceway {

template <class T> struct BallStateT {
  Vec3T<T> x, v, w;
};
using BallState = BallStateT<double>;

template <class T> struct RingStateT {
  Vec3T<T> x, v, w;
  Vec3T<T> e;    // unit axis
};
using RingState = RingStateT<double>;

template <class T> struct ContactForcesT {
  Vec3T<T> force;          // on the ball
  Vec3T<T> ball_torque;    // about the ball centre
  Vec3T<T> ring_torque;    // about the ring centre
};
using ContactForces = ContactForcesT<double>;

// Transfers the torque on the ring from the middle of the groove to the ring's centre. A groove may
// lie `offset` m along the axis from the ring's centre, and the functions in this file refer to the
// middle of the groove, which moves with v + w x (offset e).
template <class T>
RACEWAY_INLINE void from_groove(const Vec3T<T> &e, double offset, ContactForcesT<T> &f)
{
  f.ring_torque -= cross(e * offset, f.force);
}

// Sets the overlap of a ball whose position in the groove is known. Returns true if the ball is
// beyond the reach of the law. NaN must not count as a gap.
template <class T> RACEWAY_INLINE auto out_of_reach(const Raceway &p, ContactStateT<T> &c)
{
  c.overlap = c.s - p.slack;
  return c.overlap <= -p.reach;
}

// Evaluates only the geometry. Returns true if the surfaces overlap or are within reach of the law
// (or if a position is NaN); only then is the frame set.
inline bool touch(const Raceway &p, const Vec3 &d, const Vec3 &e, ContactState &c)
{
  return locate_beyond(d, e, p.centre_circle, p.slack - p.reach, c) && !out_of_reach(p, c);
}

// Computes the local motions of a contact whose position is known, including the rotations about n,
// t and w if `rotations` is true.
template <bool rotations, class T>
RACEWAY_INLINE void find_motions(const Raceway &p, const BallStateT<T> &ball,
                                 const RingStateT<T> &ring, ContactStateT<T> &c)
{
  const double Rb = p.groove.ball_radius;
  c.cos_angle = magnitude(c.nu);
  // velocities in (u, t, e), relative to the ring centre
  const Vec3T<T> dv = ball.v - ring.v;
  const T vu = dot(dv, c.u), vt = dot(dv, c.t), ve = dot(dv, ring.e);
  const T wu = dot(ball.w, c.u), wt = dot(ball.w, c.t), we = dot(ball.w, ring.e);
  const T Wu = dot(ring.w, c.u), Wt = dot(ring.w, c.t), We = dot(ring.w, ring.e);
  const T rc = c.r + Rb * c.nu, zc = c.z + Rb * c.ne;    // contact point relative to the ring
  const T Vu = Wt * zc, Vt = We * rc - Wu * zc, Ve = -Wt * rc;    // ring surface, W x (rc u + zc e)

  c.overlap_rate = (vu - Vu) * c.nu + (ve - Ve) * c.ne;
  const T roll = Rb * (we * c.nu - wu * c.ne);    // velocity along t due to the ball's rotation
  c.sliding_t = vt + roll - Vt;
  c.sliding_w = (ve - Ve) * c.nu - (vu - Vu) * c.ne - Rb * wt;
  const T turn = (vt + c.z * Wu) / c.r * rc - Wu * zc;    // velocity of the contact point along t
  c.entrainment = 0.5 * magnitude(T((vt + roll - turn) + (Vt - turn)));
  if constexpr (rotations) {
    c.spin_n = (wu - Wu) * c.nu + (we - We) * c.ne;
    c.turn_t = wt - Wt;
    c.roll_w = (we - We) * c.nu - (wu - Wu) * c.ne;    // w = n x t = nu e - ne u
  }
}

// Computes the forces and torques due to a contact from its local forces; T is the plain type of S.
template <bool couples, class T, class S>
RACEWAY_INLINE ContactForcesT<T> assemble(const Raceway &p, const Vec3T<T> &e,
                                          const ContactStateT<S> &c)
{
  const double Rb = p.groove.ball_radius;
  const T rc = c.r + Rb * c.nu, zc = c.z + Rb * c.ne;
  // w = n x t = nu e - ne u; the lever of the ball is Rb n, that of the ring rc u + zc e
  const T ft = held(c.friction_t), fw = held(c.friction_w), normal = held(c.normal);
  const T fu = -normal * c.nu + fw * c.ne, fe = -normal * c.ne - fw * c.nu;
  ContactForcesT<T> f;
  f.force = c.u * fu + c.t * T(-ft) + e * fe;
  // n x t = w, n x w = -t
  f.ball_torque = c.u * T(Rb * ft * c.ne) + e * T(-Rb * ft * c.nu) + c.t * T(Rb * fw);
  // -(rc u + zc e) x F with u x t = e, t x e = u, e x u = t
  f.ring_torque = c.u * T(-zc * ft) + c.t * T(rc * fe - zc * fu) + e * T(rc * ft);
  if constexpr (couples) {
    const T mn = held(c.couple_n), mt = held(c.couple_t), mw = held(c.couple_w);
    const Vec3T<T> couple =
        c.u * T(mn * c.nu - mw * c.ne) + c.t * mt + e * T(mn * c.ne + mw * c.nu);
    f.ball_torque -= couple;
    f.ring_torque += couple;
    // acts along t at the ball's centre, which is at r u + z e from the ring's centre
    f.force -= c.t * T(c.drag);
    f.ring_torque += e * T(c.r * c.drag) - c.u * T(c.z * c.drag);
  }
  return f;
}

}    // namespace raceway
