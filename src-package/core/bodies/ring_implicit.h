// SPDX-License-Identifier: GPL-2.0-or-later
// Motion of a ring in the implicit step: w = W + spin e, where W = (rate_x, rate_y, .) is normal to
// its axis e, so that
//   e' = W x e,    I_t W' = M_across - I_a spin (W x e),    I_a spin' = M.e
// (M_across = M - (M.e) e; the component along e includes the drive of an imposed spin). The
// gyroscopic moment is the term with the spin.
#pragma once

#include "../numbers/cubic.h"
#include "ring_drive.h"

namespace raceway {

// Adds `gained` (N_DOF values) to the velocities of the free degrees of freedom at the base,
// without moving the ring.
inline RingPose kicked(const RingProgram &p, const RingPose &base, const double *gained)
{
  RingPose r = base;
  gain(p, r, gained);
  for (int k = 0; k < 2; ++k)
    if (p.free(RingProgram::TILT + k)) r.rate[k] += gained[RingProgram::TILT + k];
  if (p.free(RingProgram::SPIN)) r.spin += gained[RingProgram::SPIN];
  return r;
}

// Moves everything except free tilts, whose axis is computed by the caller.
inline RingPose displaced(const RingProgram &p, const RingPose &base, double h, double s)
{
  RingPose r = base;
  displace(p, r, h, s);
  drive_rates(p, r, r.rate, h, s);
  if (!p.tilts_free() && p.tilts()) tilt_by(r, r.rate, h);
  r.spin = driven_spin(p, r.spin, s);
  r.angle += h * r.spin;
  return r;
}

// Performs an implicit Euler step from `base` over h to the fraction s of the host's step: pose =
// base + h times the velocities at the end. Free degrees of freedom have the velocities of the base
// plus `gained` (N_DOF values), and all others have the driven velocities.
inline RingPose moved(const RingProgram &p, const RingPose &base, const double *gained, double h,
                      double s)
{
  RingPose r = displaced(p, kicked(p, base, gained), h, s);
  if (p.tilts_free()) {
    r.e = implicit_axis(base.e, [&r](const Vec3 &e) { return r.across(e); }, h);
    tilt_of(r.e, r.tilt);
  }
  return r;
}

// Moves a ring at constant velocity for h seconds to the fraction s of the host's step. The driven
// velocities are those at the fraction s.
inline RingPose coasted(const RingProgram &p, const RingPose &base, double h, double s)
{
  RingPose r = displaced(p, base, h, s);
  if (p.tilts_free()) {
    r.e = turned_axis(base.e, base.across(), h);
    tilt_of(r.e, r.tilt);
  }
  return r;
}

// Returns `from` + b (`to` - `from`) for every coordinate, which is the base of the second stage.
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

// Returns the pose at the fraction s of a step of h seconds between two poses. Positions follow the
// cubic that also matches the velocities at both ends; velocities are interpolated linearly.
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
  r.angle = at(from.angle, from.spin, to.angle, to.spin);
  tilt_of(r.e, r.tilt);
  for (int k = 0; k < 2; ++k) r.rate[k] = from.rate[k] + s * (to.rate[k] - from.rate[k]);
  r.spin = from.spin + s * (to.spin - from.spin);
  return r;
}

}    // namespace raceway
