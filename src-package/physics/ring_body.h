// SPDX-License-Identifier: GPL-2.0-or-later
// A ring as a symmetric top in the inertial frame: unit axis e, angular velocity w,
// inertia I_a about the axis and I_t across it. Gyroscopic moments come out of the angular momentum
// L = I_t w + (I_a - I_t)(w.e) e; nothing is added by hand (docs/theory, Rings).
#ifndef RACEWAY_RING_BODY_H
#define RACEWAY_RING_BODY_H

#include "vec3.h"

namespace raceway {

struct RingInertia {
  double axial = 0.0, transverse = 0.0;    // kg m^2
};

inline Vec3 angular_momentum(const RingInertia &I, const Vec3 &w, const Vec3 &e)
{
  return w * I.transverse + e * ((I.axial - I.transverse) * dot(w, e));
}

inline Vec3 angular_velocity(const RingInertia &I, const Vec3 &L, const Vec3 &e)
{
  return L * (1.0 / I.transverse) + e * ((1.0 / I.axial - 1.0 / I.transverse) * dot(L, e));
}

// Axis after the time h at constant angular momentum L (moments act in the half kicks around this
// drift): midpoint rule, second order, |e| kept to rounding.
inline Vec3 drift_axis(const RingInertia &I, const Vec3 &L, const Vec3 &e, double h)
{
  const Vec3 half = rotate(e, angular_velocity(I, L, e) * (0.5 * h));
  return rotate(e, angular_velocity(I, L, half) * h);
}

}    // namespace raceway

#endif
