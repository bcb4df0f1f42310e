// SPDX-License-Identifier: GPL-2.0-or-later
// Relations between a shaft and the rings that it carries. A shaft is a ring without raceways
// (RingProgram, RingPose); each carried ring is fixed on its axis at a distance `at` (m) from its
// centre and has the axis, the angular velocity and the rotation angle of the shaft.
#pragma once

#include "ring_program.h"

namespace raceway {

inline Vec3 turning(const RingPose &r) { return r.across(); }
inline Vec3 turning(const RingAtom &r) { return r.w; }

// Returns the state of a ring that is carried by a shaft. `origin` is the origin of the ring.
template <class Place> Place carried(const Place &shaft, double at, const Vec3 &origin)
{
  Place ring = shaft;
  ring.x += shaft.e * at;
  ring.v += cross(turning(shaft), shaft.e) * at;
  ring.origin = origin;
  return ring;
}

// Returns the state of the shaft that carries a ring. The initial axis of the shaft was the bearing
// axis.
template <class Place> Place shaft_of(const Place &ring, double at)
{
  Place shaft = ring;
  shaft.x -= ring.e * at;
  shaft.v -= cross(turning(ring), ring.e) * at;
  shaft.origin.z -= at;
  return shaft;
}

// Returns the moment about the shaft's centre that results from a moment and a force that act `at`
// metres along its axis.
inline Vec3 moment_about_centre(const Vec3 &e, double at, const Vec3 &force, const Vec3 &moment)
{
  return moment + cross(e * at, force);
}

// Returns the acceleration of a carried ring, m/s^2; `push` (N) and `moment` (N m) act at the
// shaft's centre. Fixed and driven degrees of freedom do not contribute to the acceleration.
inline Vec3 carried_acceleration(const RingProgram &p, const RingPose &shaft, double at,
                                 const Vec3 &push, const Vec3 &moment)
{
  const Vec3 &e = shaft.e, W = shaft.across(), turn = cross(W, e);
  Vec3 growth;
  if (p.inertia.transverse > 0.0) {
    const Vec3 across = moment - e * dot(moment, e);
    growth = (across - turn * (p.inertia.axial * shaft.spin)) * (1.0 / p.inertia.transverse);
  }
  if (!p.free(RingProgram::TILT)) growth.x = 0.0;
  if (!p.free(RingProgram::TILT + 1)) growth.y = 0.0;
  return p.acceleration(push) + (cross(growth, e) + cross(W, turn)) * at;
}

}    // namespace raceway
