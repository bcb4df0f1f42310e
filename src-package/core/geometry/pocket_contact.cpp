// SPDX-License-Identifier: GPL-2.0-or-later
#include "pocket_contact.h"

namespace raceway {

PocketWall pocket_wall(const CageRing &cage, const PocketGapT<double> &gap, double radius,
                       double mass, double close, double barely)
{
  PocketWall c;
  if (!(gap.distance > 0.0) || gap.overlap <= -close) return c;
  const Vec3 n = gap.apart * (-1.0 / gap.distance), dv = gap.velocity;
  c.normal = n;
  c.side = cage.spherical ? Vec3() : cross(gap.axis, n);
  const bool touches = gap.overlap > 0.0;
  const double rate = touches ? -dot(dv, n) : 0.0, overlap = touches ? gap.overlap : barely;
  const double reduced = mass * cage.mass / (mass + cage.mass);
  c.h = cage.wall > 0.0
            ? damped_wall(cage.wall, full_damping * cage.least_play(radius), overlap, rate, reduced)
            : damped_hertz(cage.stiffness, overlap, rate, reduced);
  if (!touches) {
    c.h.force = 0.0;
    return c;
  }
  const double linear = c.h.stiffness * gap.overlap;
  const double spring = cage.wall > 0.0 ? linear : linear / 1.5;
  c.energy = (cage.wall > 0.0 ? 0.5 : 0.4) * spring * gap.overlap;
  c.loss = (c.h.force - spring) * rate;
  if (!(c.h.force > 0.0)) return c;
  // if the half clearances differ, the slot has straight walls, and the normal on them does not
  // rotate
  const bool turns =
      cage.spherical || cage.along == cage.across || (gap.around != 0.0 && gap.beyond != 0.0);
  c.bend = turns ? c.h.force / gap.distance : 0.0;
  c.force = n * c.h.force;
  const Vec3 at = n * -radius;    // from the ball's centre to the wall
  if (cage.friction > 0.0) {
    const Vec3 on = dv + cross(gap.spin, at), v = on - n * dot(on, n);
    c.braking = cage.friction * c.h.force / std::sqrt(dot(v, v) + cage.creep * cage.creep);
    c.slide = v * (c.braking / c.h.force);
    c.force -= v * c.braking;
    c.ball_torque = -cross(at, v * c.braking);
    c.loss += c.braking * dot(v, v);
  }
  c.cage_moment = -cross(gap.lever + at, c.force);
  return c;
}

PocketContact pocket_contact(const CageRing &cage, const CageMotion &m, int pocket,
                             const PocketBall &ball)
{
  const Vec3 d = ball.x - m.x;
  PocketContact c;
  c.gap = pocket_gap(cage, m.e, pocket_axis(cage, m, pocket), d, ball.v - m.v - cross(m.w, d),
                     ball.w - m.w);
  c.oil = pocket_oil(cage, c.gap, false);
  c.wall = pocket_wall(cage, c.gap, ball.radius, ball.mass);
  return c;
}

}    // namespace raceway
