// SPDX-License-Identifier: GPL-2.0-or-later
// Free, fixed and driven degrees of freedom, loads and motion of a ring, for both integrators.
//
// The bearing axis is the third axis. The degrees of freedom are x, y, z, tilt about x, tilt about
// y, and spin about the ring's own axis e.
//
// Both integrators share displacements, driven tilts, the spin and the loads, but represent the
// angular velocity differently. Velocity Verlet uses the host's vector w (RingAtom) without an
// additional rounding error (ring_verlet.h). The implicit step solves for rates (RingPose,
// ring_implicit.h).
#pragma once

#include "../geometry/ring_body.h"

namespace raceway {

enum class Freedom { fixed, free, speed, position };

// A value set for one ring; `which` is a degree of freedom, or FORCE + k or MOMENT + k of
// RingProgram.
struct RingValue {
  int which;
  double value;
};

// A radial force that rotates about the bearing axis; its phase is measured from the first radial
// axis.
struct TurningForce {
  double size = 0.0, speed = 0.0, phase = 0.0;    // N, rad/s, rad
};

// An eccentric mass that rotates with a ring whose spin is imposed.
struct Unbalance {
  double moment = 0.0, phase = 0.0;    // mass times eccentricity, kg m; phase relative to the ring,
                                       // rad
};

// A spring and damper in parallel between a ring and another ring, or between a ring and the ground
// at the ring's initial position.
struct Support {
  double stiffness = 0.0, damping = 0.0;    // in N/m and N s/m; for a tilt in N m/rad and N m s/rad
};

struct RingPlace;

inline Vec3 across_at(double angle) { return {std::cos(angle), std::sin(angle), 0.0}; }

// Program of a ring over the host's step. Times within the step are fractions s, from 0 at its
// start to 1 at its end.
struct RingProgram {
  enum { TILT = 3, SPIN = 5, N_DOF = 6, FORCE = N_DOF, MOMENT = FORCE + 3, N_VALUE = MOMENT + 3 };
  Freedom mode[N_DOF] = {Freedom::fixed, Freedom::fixed, Freedom::fixed,
                         Freedom::fixed, Freedom::fixed, Freedom::fixed};
  double mass = 0.0;
  RingInertia inertia;
  double target[2][N_DOF] =
      {};    // driven speed or position (m or rad from the origin) at both ends, linear in between
  Vec3 force[2], moment[2];    // force (N) and moment (N m) at the start and the end of the step,
                               // linear in between, before the ramp is applied
  TurningForce turning;
  Unbalance unbalance;
  // For a shaft: first moments along its axis of the loads and unbalances that act away from its
  // centre.
  Vec3 leverage[2];         // N m, at the start and the end of the step, linear in between, before
                            // the ramp is applied
  Unbalance couple;         // kg m^2
  bool apart = false;       // true if there are such loads or unbalances
  Support support[SPIN];    // supports of displacements and tilts
  bool supported = false;
  // Load due to grains (N, and N m about the centre), which is constant over the host's step and
  // not ramped.
  bool grains = false;
  Vec3 grain_force, grain_moment;
  double spin_growth = 0.0;    // rad/s^2, growth rate of a driven spin
  double ramp = 0.0;           // s, time over which the loads are applied (3s^2 - 2s^3)
  double end = 0.0,
         length = 0.0;    // age of the load at the end of the host's step, and length of that step,
                          // s

  bool free(int dof) const { return mode[dof] == Freedom::free; }
  bool tilts_free() const { return free(TILT) && free(TILT + 1); }
  bool tilts() const { return mode[TILT] != Freedom::fixed || mode[TILT + 1] != Freedom::fixed; }
  const double *inertia_at(int dof) const
  {
    return dof < TILT ? &mass : dof == SPIN ? &inertia.axial : &inertia.transverse;
  }
  double inertia_of(int dof) const { return *inertia_at(dof); }
  // Sets the N_VALUE values at one end (0 start, 1 end of the host's step).
  void set_values(int at, const double *values)
  {
    for (int k = 0; k < N_DOF; ++k) target[at][k] = values[k];
    force[at] = Vec3::from(values + FORCE);
    moment[at] = Vec3::from(values + MOMENT);
  }
  double target_at(int dof, double s) const
  {
    return target[0][dof] + s * (target[1][dof] - target[0][dof]);
  }
  double age_at(double s) const { return end - (1.0 - s) * length; }
  double share_of_load(double s) const
  {
    const double age = age_at(s);
    if (age >= ramp) return 1.0;
    const double x = age / ramp;
    return x * x * (3.0 - 2.0 * x);
  }
  // Returns the force of the loads on a ring that has rotated by `angle` (rad), N.
  Vec3 force_at(double s, double angle) const
  {
    Vec3 total = force[0] + (force[1] - force[0]) * s;
    if (turning.size != 0.0)
      total += across_at(turning.speed * age_at(s) + turning.phase) * turning.size;
    total = total * share_of_load(s);
    if (grains) total += grain_force;
    return unbalance.moment == 0.0 ? total : total + unbalance_force(unbalance, s, angle);
  }
  // Returns the centrifugal force of the eccentric mass plus the inertial force due to changes in
  // spin.
  Vec3 unbalance_force(const Unbalance &of, double s, double angle) const
  {
    if (mode[SPIN] != Freedom::speed) return {};
    const Vec3 out = across_at(angle + of.phase);
    const double w = target_at(SPIN, s);
    return (out * (w * w) - Vec3{-out.y, out.x, 0.0} * spin_growth) * of.moment;
  }
  // Returns the moment of the loads about the centre of a ring at the given position, N m.
  Vec3 moment_at(double s, const RingPlace &) const;
  // Return the force (N) and moment (N m) of the supports on the ring; the tilt rates of the ring
  // are W (ring_implicit.h).
  Vec3 support_force(const RingPlace &) const;
  Vec3 support_moment(const RingPlace &, double rate_1, double rate_2) const;
  double support_energy(const RingPlace &) const;    // J, stored in the springs
  double support_loss(const RingPlace &, double rate_1, double rate_2) const;    // W, dissipated in
                                                                                 // the dampers
  // Returns the acceleration of the free degrees of freedom under the total force (N), m/s^2.
  Vec3 acceleration(const Vec3 &push) const
  {
    return {free(0) ? push.x / mass : 0.0, free(1) ? push.y / mass : 0.0,
            free(2) ? push.z / mass : 0.0};
  }
};

// Position and orientation of a ring, including its rotation angles.
struct RingPlace {
  Vec3 x, v, e{0.0, 0.0, 1.0}, origin;
  double angle = 0.0;             // rad, rotation about its axis
  double tilt[2] = {0.0, 0.0};    // rad, rotation vector that turns the bearing axis into e
};

inline Vec3 RingProgram::moment_at(double s, const RingPlace &r) const
{
  Vec3 total = (moment[0] + (moment[1] - moment[0]) * s) * share_of_load(s);
  if (grains) total += grain_moment;
  if (!apart) return total;
  const Vec3 lever = (leverage[0] + (leverage[1] - leverage[0]) * s) * share_of_load(s);
  return total + cross(r.e, lever + unbalance_force(couple, s, r.angle));
}

inline Vec3 RingProgram::support_force(const RingPlace &r) const
{
  const Vec3 d = r.x - r.origin;
  return {-(support[0].stiffness * d.x + support[0].damping * r.v.x),
          -(support[1].stiffness * d.y + support[1].damping * r.v.y),
          -(support[2].stiffness * d.z + support[2].damping * r.v.z)};
}

inline Vec3 RingProgram::support_moment(const RingPlace &r, double rate_1, double rate_2) const
{
  const Support &first = support[TILT], &second = support[TILT + 1];
  return {-(first.stiffness * r.tilt[0] + first.damping * rate_1),
          -(second.stiffness * r.tilt[1] + second.damping * rate_2), 0.0};
}

inline double RingProgram::support_energy(const RingPlace &r) const
{
  const Vec3 d = r.x - r.origin;
  const double moved[] = {d.x, d.y, d.z, r.tilt[0], r.tilt[1]};
  double sum = 0.0;
  for (int k = 0; k < SPIN; ++k) sum += 0.5 * support[k].stiffness * moved[k] * moved[k];
  return sum;
}

inline double RingProgram::support_loss(const RingPlace &r, double rate_1, double rate_2) const
{
  const double rate[] = {r.v.x, r.v.y, r.v.z, rate_1, rate_2};
  double sum = 0.0;
  for (int k = 0; k < SPIN; ++k) sum += support[k].damping * rate[k] * rate[k];
  return sum;
}

// State of a ring in velocity Verlet, i.e. the host's atom.
struct RingAtom : RingPlace {
  Vec3 w;    // rad/s
};

// State of a ring in the implicit step.
struct RingPose : RingPlace {
  double rate[2] = {0.0, 0.0};    // rad/s, components of W across the bearing axis
  double spin = 0.0;              // rad/s

  const double *speed_of(int dof) const    // m/s or rad/s
  {
    const double *const of[] = {&v.x, &v.y, &v.z, &rate[0], &rate[1], &spin};
    return of[dof];
  }
  Vec3 across(const Vec3 &axis) const
  {
    return {rate[0], rate[1], -(rate[0] * axis.x + rate[1] * axis.y) / axis.z};
  }
  Vec3 across() const { return across(e); }
  Vec3 angular_velocity() const { return across() + e * spin; }
  void set_angular_velocity(const Vec3 &w)
  {
    spin = dot(w, e);
    rate[0] = w.x - spin * e.x;
    rate[1] = w.y - spin * e.y;
  }
};

// Returns the pose of a ring relative to another ring, for the supports between them. The axis is
// unchanged.
inline RingPose seen_from(const RingPose &r, const RingPose &from)
{
  RingPose s = r;
  s.x -= from.x - from.origin;
  s.v -= from.v;
  for (int k = 0; k < 2; ++k) {
    s.tilt[k] -= from.tilt[k];
    s.rate[k] -= from.rate[k];
  }
  return s;
}

// Computes the rotation vector (rad), normal to the bearing axis, that turns the bearing axis into
// e.
inline void tilt_of(const Vec3 &e, double *tilt)
{
  const double sine = std::sqrt(e.x * e.x + e.y * e.y),
               factor = sine > 0.0 ? std::atan2(sine, e.z) / sine : 1.0;
  tilt[0] = -factor * e.y + 0.0;    // avoids minus zero
  tilt[1] = factor * e.x + 0.0;
}

}    // namespace raceway
