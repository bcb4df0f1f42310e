// SPDX-License-Identifier: GPL-2.0-or-later
// Contact between a grain and another grain or a wall: a linear spring and dashpot in the normal
// direction, and friction modelled by a spring with history (Cundall and Strack, Geotechnique 29,
// 1979, 47; docs/fix_bearing_grains).
#pragma once

#include "../numbers/vec3.h"
#include "grain_law.h"

namespace raceway {

// State of a contact that is kept between steps. Forces and moments act on the first body.
struct GrainContact {
  Vec3 spring;            // m, tangential
  Vec3 force;             // N
  Vec3 couple;            // N, normal x force, i.e. the moment on a body divided by that body's
                          // lever
  Vec3 moment;            // N m, moment of the force about the centre of a rotating wall
  double energy = 0.0;    // J, stored in both springs
};

// Two bodies in contact during a step: a grain, and a second grain or a wall that rotates about its
// centre.
struct GrainMeeting {
  double mass;       // kg, reduced
  double overlap;    // m
  Vec3 n;            // unit normal towards the first body
  Vec3 v;            // m/s, velocity of the first body's centre relative to that of the second
  Vec3 turn;         // m/s, sum over the grains in contact of angular velocity times lever
  Vec3 arm, spin;    // for a wall: position of the contact relative to the wall's centre, m, and
                     // angular velocity of the wall, rad/s
};

// Advances a contact by dt (s) and returns the energy dissipated in it (J), i.e. the work of the
// bodies on the contact minus the energy stored in the springs. Velocities are evaluated at the
// half step; forces and moments are averaged over both ends of the step. The result equals the
// energy dissipated by velocity Verlet, except that it neglects the change of the grains' levers
// within a step.
inline double advance(GrainContact &c, const GrainLaw &law, const GrainMeeting &m, double dt)
{
  const GrainContact before = c;
  c = GrainContact();
  if (m.overlap > 0.0) {
    const Vec3 v = m.v - cross(m.turn, m.n) - cross(m.spin, m.arm);
    const double closing = -dot(v, m.n), damping = law.damping(m.mass),
                 push = law.stiffness * m.overlap + damping * closing,
                 normal = push > 0.0 ? push : 0.0;    // no attraction
    const double kt = GrainLaw::tangential * law.stiffness;
    const Vec3 slide = v + m.n * closing;
    // the spring turns with the tangent plane of the contact and keeps its length
    Vec3 s = before.spring - m.n * dot(before.spring, m.n);
    const double length = norm(before.spring), left = norm(s);
    if (left > 0.0) s = s * (length / left);
    s += slide * dt;
    Vec3 along = s * -kt - slide * (GrainLaw::tangential * damping);
    const double most = law.friction * normal, wanted = norm(along);
    if (wanted > most) {
      along = along * (most / wanted);
      s = along * (-1.0 / kt);
    }
    c.spring = s;
    c.force = m.n * normal + along;
    c.couple = cross(m.n, c.force);
    c.moment = cross(m.arm, c.force);
    c.energy = 0.5 * law.stiffness * m.overlap * m.overlap + 0.5 * kt * dot(s, s);
  }
  const double power = dot(before.force + c.force, m.v) - dot(before.couple + c.couple, m.turn) -
                       dot(before.moment + c.moment, m.spin);
  return -0.5 * dt * power - (c.energy - before.energy);
}

}    // namespace raceway
