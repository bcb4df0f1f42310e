// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the motion within and between steps to test_physics_instants.py.
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/step/bearing_integrator.h"

using namespace raceway;

// Computes position and velocity in the lab frame after a drift of h seconds.
EXPORT(void, drift,
       (const double x[3], const double v[3], double h, double x_new[3], double v_new[3]))
{
  LaneFrame f;
  for (int i = 0; i < lanes; ++i) f.set(i, Vec3::from(x));
  const Vec3L u = f.local(Vec3::from(v));
  Lane turn;
  const LaneFrame g = f.drifted(u, h, turn);
  const Vec3L place = g.place(), speed = g.lab(u);
  for (int k = 0; k < 3; ++k) {
    x_new[k] = (k == 0 ? place.x : k == 1 ? place.y : place.z)[0];
    v_new[k] = (k == 0 ? speed.x : k == 1 ? speed.y : speed.z)[0];
  }
}

EXPORT(void, turn, (double angle, double out[2]))
{
  Lane cosine, sine;
  small_turn(all_lanes(angle), cosine, sine);
  out[0] = cosine[0];
  out[1] = sine[0];
}

EXPORT(double, cubic, (double s, double h, double x_from, double v_from, double x_to, double v_to))
{
  return Cubic(s, h)(x_from, v_from, x_to, v_to);
}

// Computes the axis of a ring half-way between two instants h seconds apart; the ring rotates about
// `w` at a constant rate.
EXPORT(void, axis_between, (const double w[3], double h, double e[3]))
{
  const Vec3 W = Vec3::from(w);
  RingPose from, to;
  from.e = rotate({0.0, 0.0, 1.0}, {0.1, -0.05, 0.0});
  from.set_angular_velocity(W);
  to.e = rotate(from.e, W * h);
  to.set_angular_velocity(W);
  const Vec3 found = between(from, to, h, 0.5).e, truth = rotate(from.e, W * (0.5 * h));
  (found - truth).to(e);
}
