// SPDX-License-Identifier: GPL-2.0-or-later
// A ring as a symmetric top in the inertial frame, with the unit axis e, the angular velocity w,
// and the moments of inertia I_a about the axis and I_t about a diameter. Gyroscopic moments follow
// from the angular momentum L = I_t w + (I_a - I_t)(w.e) e; no separate gyroscopic term is added
// (docs/theory, Rings).
#pragma once

#include "../numbers/vec3.h"

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

// The functions below return the axis e after the time h. They differ in how the integrators treat
// the angular velocity within the step.

// Velocity Verlet: the moments act in the half kicks before and after the drift, so the angular
// momentum L is constant during the drift. The midpoint rule is of second order and preserves |e|
// to rounding accuracy.
inline Vec3 drift_axis(const RingInertia &I, const Vec3 &L, const Vec3 &e, double h)
{
  const Vec3 half = rotate(e, angular_velocity(I, L, e) * (0.5 * h));
  return rotate(e, angular_velocity(I, L, half) * h);
}

// An implicit stage: e_new = e + h W x e_new where the angular velocity is that at the end of the
// stage, as for every other coordinate in the stage. `across` returns W (normal to the axis) for a
// given axis. Precondition: e.z > 0. The iteration converges linearly with the factor h |W|.
template <class Across> Vec3 implicit_axis(const Vec3 &e, Across across, double h)
{
  Vec3 end = e;
  for (int iteration = 0; iteration < 4; ++iteration) {
    const Vec3 turn = cross(across(end), end);
    end.x = e.x + h * turn.x;
    end.y = e.y + h * turn.y;
    end.z = std::sqrt(1.0 - end.x * end.x - end.y * end.y);
  }
  return end;
}

// A drift with constant angular velocity W normal to the axis; the result is exact.
inline Vec3 turned_axis(const Vec3 &e, const Vec3 &W, double h) { return rotate(e, W * h); }

}    // namespace raceway
