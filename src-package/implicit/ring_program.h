// SPDX-License-Identifier: GPL-2.0-or-later
// A ring under an implicit step: what is free, fixed or driven of it, its loads, and its motion.
//
// Names here have the bearing axis third. Degrees of freedom: x, y, z, tilt about x, tilt about y,
// spin about the ring's own axis e. The angular velocity is w = W + spin e with W across e, W =
// (rate_x, rate_y, .), so that
//   e' = W x e,    I_t W' = M_across - I_a spin (W x e),    I_a spin' = M.e
// (M_across = M - (M.e) e: along e sits what drives an imposed spin). The gyroscopic moment is the
// term with the spin.
#ifndef RACEWAY_RING_PROGRAM_H
#define RACEWAY_RING_PROGRAM_H

#include "../physics/ring_body.h"
#include "cubic.h"

namespace raceway {

enum class Freedom { fixed, free, speed, position };

// What happens to a ring over the host's step. Times within it are shares s, 0 at its start to 1 at
// its end.
struct RingProgram {
  enum { TILT = 3, SPIN = 5, N_DOF = 6 };
  Freedom mode[N_DOF] = {Freedom::fixed, Freedom::fixed, Freedom::fixed,
                         Freedom::fixed, Freedom::fixed, Freedom::fixed};
  double mass = 0.0;
  RingInertia inertia;
  double target[2][N_DOF] =
      {};    // driven speed or position (m or rad from the origin) at both ends, linear between
  Vec3 force[2], moment[2];    // N, N m, at both ends, linear between, before the ramp
  double ramp = 0.0;           // s, over which the loads come on (3s^2 - 2s^3)
  double end = 0.0,
         length = 0.0;    // s: age of the load at the end of the host's step, length of that step

  bool free(int dof) const { return mode[dof] == Freedom::free; }
  double inertia_of(int dof) const
  {
    return dof < TILT ? mass : dof == SPIN ? inertia.axial : inertia.transverse;
  }
  double target_at(int dof, double s) const
  {
    return target[0][dof] + s * (target[1][dof] - target[0][dof]);
  }
  double share_of_load(double s) const
  {
    const double age = end - (1.0 - s) * length;
    if (age >= ramp) return 1.0;
    const double x = age / ramp;
    return x * x * (3.0 - 2.0 * x);
  }
  Vec3 force_at(double s) const
  {
    return (force[0] + (force[1] - force[0]) * s) * share_of_load(s);
  }
  Vec3 moment_at(double s) const
  {
    return (moment[0] + (moment[1] - moment[0]) * s) * share_of_load(s);
  }
};

struct RingPose {
  Vec3 x, v, e{0.0, 0.0, 1.0}, origin;
  double rate[2] = {0.0, 0.0};       // rad/s, W across the bearing axis
  double spin = 0.0, angle = 0.0;    // rad/s, rad
  double tilt[2] = {0.0, 0.0};       // rad, rotation vector from the bearing axis to e

  Vec3 across() const { return {rate[0], rate[1], -(rate[0] * e.x + rate[1] * e.y) / e.z}; }
  Vec3 angular_velocity() const { return across() + e * spin; }
  void set_angular_velocity(const Vec3 &w)
  {
    spin = dot(w, e);
    rate[0] = w.x - spin * e.x;
    rate[1] = w.y - spin * e.y;
  }
};

// The rotation vector (rad) across the bearing axis that turns it into e.
inline void tilt_of(const Vec3 &e, double *tilt)
{
  const double sine = std::sqrt(e.x * e.x + e.y * e.y),
               factor = sine > 0.0 ? std::atan2(sine, e.z) / sine : 1.0;
  tilt[0] = -factor * e.y + 0.0;    // no minus zero
  tilt[1] = factor * e.x;
}

// Implicit Euler from `base` over h to the share s of the host's step: pose = base + h (velocities
// at the end), these being those of the base plus `gained` (6 values) where free and the driven
// ones elsewhere.
inline RingPose moved(const RingProgram &p, const RingPose &base, const double *gained, double h,
                      double s)
{
  RingPose r = base;
  double x[3], v[3], origin[3];
  base.x.to(x);
  base.v.to(v);
  base.origin.to(origin);
  for (int k = 0; k < 3; ++k) {
    switch (p.mode[k]) {
      case Freedom::fixed: v[k] = 0.0; break;
      case Freedom::free: v[k] += gained[k]; break;
      case Freedom::speed: v[k] = p.target_at(k, s); break;
      case Freedom::position: v[k] = (origin[k] + p.target_at(k, s) - x[k]) / h; break;
    }
    x[k] += h * v[k];
  }
  r.x = Vec3::from(x);
  r.v = Vec3::from(v);
  for (int k = 0; k < 2; ++k) {
    const int dof = RingProgram::TILT + k;
    switch (p.mode[dof]) {
      case Freedom::fixed: r.rate[k] = 0.0; break;
      case Freedom::free: r.rate[k] += gained[dof]; break;
      case Freedom::speed: r.rate[k] = p.target_at(dof, s); break;
      case Freedom::position: r.rate[k] = (p.target_at(dof, s) - base.tilt[k]) / h; break;
    }
  }
  if (p.free(RingProgram::TILT) && p.free(RingProgram::TILT + 1)) {
    for (int iteration = 0; iteration < 4;
         ++iteration) {    // e = base + h W x e, a contraction by h |W|
      const Vec3 turn = cross(r.across(), r.e);
      r.e.x = base.e.x + h * turn.x;
      r.e.y = base.e.y + h * turn.y;
      r.e.z = std::sqrt(1.0 - r.e.x * r.e.x - r.e.y * r.e.y);
    }
    tilt_of(r.e, r.tilt);
  } else if (p.mode[RingProgram::TILT] != Freedom::fixed ||
             p.mode[RingProgram::TILT + 1] != Freedom::fixed) {
    // driven tilts define the axis outright: no drift from adding up small rotations
    for (int k = 0; k < 2; ++k) r.tilt[k] = base.tilt[k] + h * r.rate[k];
    r.e = rotate({0.0, 0.0, 1.0}, {r.tilt[0], r.tilt[1], 0.0});
  }
  switch (p.mode[RingProgram::SPIN]) {
    case Freedom::fixed: r.spin = 0.0; break;
    case Freedom::free: r.spin = base.spin + gained[RingProgram::SPIN]; break;
    default: r.spin = p.target_at(RingProgram::SPIN, s); break;
  }
  r.angle = base.angle + h * r.spin;
  return r;
}

// On its way for h seconds with the velocities that it has (driven ones: of the share s), to the
// share s of the host's step.
inline RingPose coasted(const RingProgram &p, const RingPose &base, double h, double s)
{
  const double nothing[RingProgram::N_DOF] = {};
  RingPose r = moved(p, base, nothing, h, s);
  if (p.free(RingProgram::TILT) && p.free(RingProgram::TILT + 1)) {
    r.e = rotate(base.e, base.across() * h);
    tilt_of(r.e, r.tilt);
  }
  return r;
}

// With the velocities of the base plus `gained` where free; nothing moves.
inline RingPose kicked(const RingProgram &p, const RingPose &base, const double *gained)
{
  RingPose r = base;
  double v[3];
  base.v.to(v);
  for (int k = 0; k < 3; ++k)
    if (p.free(k)) v[k] += gained[k];
  r.v = Vec3::from(v);
  for (int k = 0; k < 2; ++k)
    if (p.free(RingProgram::TILT + k)) r.rate[k] += gained[RingProgram::TILT + k];
  if (p.free(RingProgram::SPIN)) r.spin += gained[RingProgram::SPIN];
  return r;
}

// from + b (to - from) in every coordinate: the base of a second stage.
inline RingPose beyond(const RingPose &from, const RingPose &to, double b)
{
  RingPose r = to;
  r.x = from.x + (to.x - from.x) * b;
  r.v = from.v + (to.v - from.v) * b;
  r.e.x = from.e.x + b * (to.e.x - from.e.x);
  r.e.y = from.e.y + b * (to.e.y - from.e.y);
  r.e.z = std::sqrt(1.0 - r.e.x * r.e.x - r.e.y * r.e.y);
  for (int k = 0; k < 2; ++k) {
    r.rate[k] = from.rate[k] + b * (to.rate[k] - from.rate[k]);
    r.tilt[k] = from.tilt[k] + b * (to.tilt[k] - from.tilt[k]);
  }
  r.spin = from.spin + b * (to.spin - from.spin);
  r.angle = from.angle + b * (to.angle - from.angle);
  return r;
}

// Share s of a step of h seconds on its way from one pose to the next: places by the cubic that has
// the velocities of both ends too, velocities linear between them.
inline RingPose between(const RingPose &from, const RingPose &to, double h, double s)
{
  const Cubic at(s, h);
  RingPose r = to;
  r.x = at(from.x, from.v, to.x, to.v);
  r.v = from.v + (to.v - from.v) * s;
  if (from.e.x != to.e.x || from.e.y != to.e.y) {
    r.e = at(from.e, cross(from.across(), from.e), to.e, cross(to.across(), to.e));
    r.e = r.e * (1.0 / norm(r.e));
  }
  for (int k = 0; k < 2; ++k) r.rate[k] = from.rate[k] + s * (to.rate[k] - from.rate[k]);
  r.spin = from.spin + s * (to.spin - from.spin);
  return r;
}

}    // namespace raceway

#endif
