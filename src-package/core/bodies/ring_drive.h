// SPDX-License-Identifier: GPL-2.0-or-later
// Free, fixed and driven motion of a ring, used by both integrators.
#pragma once

#include "ring_program.h"

namespace raceway {

// Adds `gained` (3 values, m/s) to the velocities of the free degrees of freedom.
inline void gain(const RingProgram &p, RingPlace &r, const double *gained)
{
  double v[3];
  r.v.to(v);
  for (int k = 0; k < 3; ++k)
    if (p.free(k)) v[k] += gained[k];
  r.v = Vec3::from(v);
}

// Moves a ring for h seconds to the fraction s of the host's step. Free degrees of freedom move at
// their current velocity.
inline void displace(const RingProgram &p, RingPlace &r, double h, double s)
{
  double x[3], v[3], origin[3];
  r.x.to(x);
  r.v.to(v);
  r.origin.to(origin);
  for (int k = 0; k < 3; ++k) {
    if (p.mode[k] == Freedom::fixed) v[k] = 0.0;
    if (p.mode[k] == Freedom::speed) v[k] = p.target_at(k, s);
    if (p.mode[k] == Freedom::position) {
      const double target = origin[k] + p.target_at(k, s);
      v[k] = (target - x[k]) / h;
      x[k] = target;
    } else {
      x[k] += h * v[k];
    }
  }
  r.x = Vec3::from(x);
  r.v = Vec3::from(v);
}

// Sets the tilt rates (rad/s): a free tilt keeps its rate; any other tilt has the driven rate or 0.
inline void drive_rates(const RingProgram &p, const RingPlace &r, double *rate, double h, double s)
{
  for (int k = 0; k < 2; ++k) {
    const int dof = RingProgram::TILT + k;
    switch (p.mode[dof]) {
      case Freedom::fixed: rate[k] = 0.0; break;
      case Freedom::free: break;
      case Freedom::speed: rate[k] = p.target_at(dof, s); break;
      case Freedom::position: rate[k] = (p.target_at(dof, s) - r.tilt[k]) / h; break;
    }
  }
}

// Driven tilts set the axis directly, so that small rotations do not accumulate and cause a drift.
inline void tilt_by(RingPlace &r, const double *rate, double h)
{
  for (int k = 0; k < 2; ++k) r.tilt[k] += rate[k] * h;
  r.e = rotate({0.0, 0.0, 1.0}, {r.tilt[0], r.tilt[1], 0.0});
}

// Returns the spin (rad/s), which is `spin` if the spin is free and otherwise the driven spin or 0.
inline double driven_spin(const RingProgram &p, double spin, double s)
{
  switch (p.mode[RingProgram::SPIN]) {
    case Freedom::fixed: return 0.0;
    case Freedom::free: return spin;
    default: return p.target_at(RingProgram::SPIN, s);
  }
}

}    // namespace raceway
