// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of a ring in velocity Verlet: half kicks, drift and supports.
#pragma once

#include "ring_drive.h"

namespace raceway {

// Computes the force of springs and dampers at the end of a velocity Verlet step. The velocities
// lag by half a step, `half` (s; 0 if they do not lag). `push` (N) is the sum of all other forces.
// Dampers are treated implicitly, so they do not limit the time step: v = v_half + half (push - K d
// - C v)/m.
inline double verlet_support(const Support &on, double displacement, double behind, double push,
                             double inertia, double half)
{
  const double spring = -on.stiffness * displacement;
  const double rate =
      (behind + half * (push + spring) / inertia) / (1.0 + half * on.damping / inertia);
  return spring - on.damping * rate;
}

// One end of a support between two rings, for one degree of freedom in velocity Verlet. `push` is
// the sum of all other forces except `ground`, the support to the ground.
struct SupportEnd {
  bool free;
  double displacement, behind, push, inertia;
  Support ground;
};

// Does the same for a support between two rings. The damper of the support and the damper between
// the second ring and the ground are implicit in the velocities of both rings. Returns the force on
// the first ring.
inline double verlet_support(const Support &on, const SupportEnd &held, const SupportEnd &holder,
                             double half)
{
  const double spring = -on.stiffness * (held.displacement - holder.displacement);
  const double a = half / held.inertia, b = holder.free ? half / holder.inertia : 0.0;
  const double v = held.behind + a * (held.push + spring),
               u = holder.behind +
                   b * (holder.push - spring - holder.ground.stiffness * holder.displacement);
  const double first = a * on.damping, second = b * on.damping,
               whole = 1.0 + second + b * holder.ground.damping;
  const double determinant = (1.0 + first) * whole - first * second;
  const double rate = (v * (whole - second) - u) / determinant;
  return spring - on.damping * rate;
}

// Applies a force (N) and a moment (N m) to the free degrees of freedom for h seconds without
// moving the ring.
inline RingAtom kicked(const RingProgram &p, const RingAtom &base, const Vec3 &force,
                       const Vec3 &moment, double h)
{
  RingAtom r = base;
  double gained[3] = {}, push[3];
  force.to(push);
  for (int k = 0; k < 3; ++k)
    if (p.free(k)) gained[k] = h / p.mass * push[k];
  gain(p, r, gained);
  if (p.tilts_free()) {
    // the momentum includes the gyroscopic coupling; if the spin is imposed, its drive takes the
    // reaction
    const double spin = dot(r.w, r.e);
    r.w = angular_velocity(p.inertia, angular_momentum(p.inertia, r.w, r.e) + moment * h, r.e);
    if (!p.free(RingProgram::SPIN)) r.w += r.e * (spin - dot(r.w, r.e));
    return r;
  }
  // with only one free tilt there is no gyroscopic coupling
  if (p.free(RingProgram::TILT)) r.w.x += h / p.inertia.transverse * moment.x;
  if (p.free(RingProgram::TILT + 1)) r.w.y += h / p.inertia.transverse * moment.y;
  if (p.free(RingProgram::SPIN)) r.w += r.e * (h / p.inertia.axial * dot(moment, r.e));
  return r;
}

// Moves a ring at constant velocity for h seconds to the end of the host's step.
inline RingAtom coasted(const RingProgram &p, const RingAtom &base, double h)
{
  RingAtom r = base;
  displace(p, r, h, 1.0);
  const double along = dot(r.w, r.e), spin = driven_spin(p, along, 1.0);
  if (p.tilts_free()) {
    const Vec3 L = angular_momentum(p.inertia, r.w, r.e);
    r.e = drift_axis(p.inertia, L, r.e, h);
    r.w = angular_velocity(p.inertia, L, r.e);
    r.w += r.e * (spin - dot(r.w, r.e));
    tilt_of(r.e, r.tilt);
  } else if (p.tilts()) {
    const Vec3 across = r.w - r.e * along;
    double rate[2] = {across.x, across.y};
    drive_rates(p, r, rate, h, 1.0);
    tilt_by(r, rate, h);
    r.w = Vec3{rate[0], rate[1], 0.0} + r.e * spin;
  } else if (!p.free(RingProgram::SPIN)) {
    r.w = r.e * spin;
  }
  r.angle += spin * h;
  return r;
}

}    // namespace raceway
