// SPDX-License-Identifier: GPL-2.0-or-later
// How the force of a raceway on a ball changes with velocity and position: what an implicit step solves with.
//
// f = -N n - f_t t - f_w w at the contact point (contact.h), N = max(0, Q + C rate), friction by the smoothed
// Coulomb law f_t t + f_w w = mu N eps,  eps = s/sqrt(|s|^2 + v_0^2),  s = s_t t + s_w w. With V the velocity of
// ball surface against ring surface at the contact point and X the place of the ball against the groove:
//   D = -df/dV = C n n + mu C eps n + g (t t + w w - eps eps),          g = mu N/sqrt(|s|^2 + v_0^2)
//   K = -df/dX = k n n + mu k eps n + N/s_g w w + N nu/r t t
// (products of two vectors are dyads; C and k count only while N > 0; s_g is the distance of the ball from the
// circle of groove centres and r from the axis: the last two terms turn the normal as the ball moves across and
// along the groove). Held fixed in both: C, mu and v_0 (hence film and entrainment), the constants' dependence
// on the contact angle, and the turn of t and w. They change the rate of Newton's method, not its result.
#ifndef RACEWAY_CONTACT_JACOBIAN_H
#define RACEWAY_CONTACT_JACOBIAN_H

#include "contact.h"

namespace raceway {

struct Mat3 {
  double a[9] = {};    // rows

  // += s p q^T
  void add(double s, const Vec3 &p, const Vec3 &q)
  {
    const double x = s * p.x, y = s * p.y, z = s * p.z;
    a[0] += x * q.x; a[1] += x * q.y; a[2] += x * q.z;
    a[3] += y * q.x; a[4] += y * q.y; a[5] += y * q.z;
    a[6] += z * q.x; a[7] += z * q.y; a[8] += z * q.z;
  }
  Vec3 operator*(const Vec3 &v) const
  {
    return {a[0] * v.x + a[1] * v.y + a[2] * v.z, a[3] * v.x + a[4] * v.y + a[5] * v.z,
            a[6] * v.x + a[7] * v.y + a[8] * v.z};
  }
};

// v^T M
inline Vec3 operator*(const Vec3 &v, const Mat3 &m)
{
  return {v.x * m.a[0] + v.y * m.a[3] + v.z * m.a[6], v.x * m.a[1] + v.y * m.a[4] + v.z * m.a[7],
          v.x * m.a[2] + v.y * m.a[5] + v.z * m.a[8]};
}

// M [v]x: the column-wise cross product, (M [v]x) y = M (v x y)
inline Mat3 times_cross(const Mat3 &m, const Vec3 &v)
{
  Mat3 r;
  for (int i = 0; i < 9; i += 3) {
    r.a[i] = m.a[i + 1] * v.z - m.a[i + 2] * v.y;
    r.a[i + 1] = m.a[i + 2] * v.x - m.a[i] * v.z;
    r.a[i + 2] = m.a[i] * v.y - m.a[i + 1] * v.x;
  }
  return r;
}

// [v]x M
inline Mat3 cross_times(const Vec3 &v, const Mat3 &m)
{
  Mat3 r;
  for (int j = 0; j < 3; ++j) {
    r.a[j] = v.y * m.a[6 + j] - v.z * m.a[3 + j];
    r.a[3 + j] = v.z * m.a[j] - v.x * m.a[6 + j];
    r.a[6 + j] = v.x * m.a[3 + j] - v.y * m.a[j];
  }
  return r;
}

// hd D + hk K and hd D alone, for a live contact; e is the axis of the ring.
struct ContactJacobian {
  Vec3 normal;      // ball -> raceway
  Mat3 both;        // hd D + hk K
  Mat3 damping;     // hd D
};

inline ContactJacobian contact_jacobian(const ContactState &c, double slack, const Vec3 &e, double hd, double hk,
                                        bool secant)
{
  ContactJacobian j;
  j.normal = c.u * c.nu + e * c.ne;
  const Vec3 w = e * c.nu - c.u * c.ne;    // n x t
  if (c.normal > 0.0) {
    const double g = c.mu > 0.0 ? c.ct : 0.0;
    double at = 0.0, aw = 0.0;    // eps
    if (g > 0.0) {
      const double i = g / (c.mu * c.normal);
      at = c.sliding_t * i;
      aw = c.sliding_w * i;
    }
    const Vec3 eps = c.t * at + w * aw;
    const Vec3 pull = j.normal + eps * c.mu;
    j.damping.add(hd * c.damping, pull, j.normal);
    j.damping.add(hd * g, c.t, c.t);
    j.damping.add(hd * g, w, w);
    if (!secant) j.damping.add(-hd * g, eps, eps);
    j.both = j.damping;
    j.both.add(hk * c.stiffness, pull, j.normal);
    j.both.add(hk * c.normal / (c.overlap + slack), w, w);
    j.both.add(hk * c.normal * c.nu / c.r, c.t, c.t);
  }
  return j;
}

}    // namespace raceway

#endif
