// SPDX-License-Identifier: GPL-2.0-or-later
// Integrates the collision of a sphere with a wall or with another sphere by velocity Verlet, for
// test_physics_grain.py.
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/laws/grain_contact.h"

using namespace raceway;

RECORD(Collision, double normal, along, spin, lost, time;)

// Simulates a sphere of mass m and radius R that hits a plane wall at rest. Before the collision,
// the sphere has the velocity `normal` towards the wall, the velocity `along` the wall, and a spin
// that moves its surface in the direction of `along`.
FORMULA(Collision, grain_collision,
        (double stiffness, double restitution, double friction, double m, double R, double normal,
         double along, double spin, double dt))
{
  const GrainLaw law = {stiffness, restitution, friction};
  GrainContact c;
  const Vec3 n = {0.0, 0.0, 1.0};
  double z = R * (1.0 - 1e-12), lost = 0.0, time = 0.0;
  // spin about -y moves the lowest point along +x
  Vec3 v = {along, 0.0, -normal}, w = {0.0, -spin, 0.0}, f, torque;
  const double inertia = 0.4 * m * R * R;
  do {
    v += f * (0.5 * dt / m);
    w += torque * (0.5 * dt / inertia);
    z += v.z * dt;
    const double overlap = R - z, lever = R - std::fmax(0.0, overlap);
    lost += advance(c, law, {m, overlap, n, v, w * lever, {}, {}}, dt);
    f = c.force;
    torque = -c.couple * lever;
    v += f * (0.5 * dt / m);
    w += torque * (0.5 * dt / inertia);
    time += dt;
  } while (z < R && time < 1.0);
  return {v.z, v.x, -w.y, lost, time};
}
