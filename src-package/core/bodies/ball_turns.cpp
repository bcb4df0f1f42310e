// SPDX-License-Identifier: GPL-2.0-or-later
#include "ball_turns.h"

#include "../numbers/cubic.h"
#include "body_group.h"

namespace raceway {

// Returns the rotation about the bearing axis through the azimuth of the frame.
static Quaternion azimuth(const LaneFrame &f, int lane)
{
  return Quaternion::by({0.0, 0.0, std::atan2(f.s[lane], f.c[lane])});
}

void BallTurns::load(int lane, const LaneFrame &f, const Quaternion &lab)
{
  from[lane] = now[lane] = azimuth(f, lane).back() * lab;
}

Quaternion BallTurns::stored(int lane, const LaneFrame &f) const
{
  return (azimuth(f, lane) * from[lane]).normal();
}

void BallTurns::start() { std::copy(from, from + lanes, base); }

void BallTurns::accept() { std::copy(now, now + lanes, from); }

void BallTurns::move(const BodyGroup &g, double h)
{
  for (int i = 0; i < lanes; ++i) {
    turn[i] = {h * g.w.x[i], h * g.w.y[i], h * g.w.z[i] - g.turn[i]};
    now[i] = Quaternion::by(turn[i]) * base[i];
  }
}

void BallTurns::coast(const BodyGroup &g, double h, bool on)
{
  std::copy(on ? now : from, (on ? now : from) + lanes, base);
  move(g, h);
}

void BallTurns::second_base(double beyond)
{
  for (int i = 0; i < lanes; ++i) base[i] = Quaternion::by(turn[i] * beyond) * from[i];
}

void BallTurns::between(const BodyGroup &g, const LaneFrame &end_frame, const Vec3L &v,
                        const Vec3L &w, double h, double s)
{
  const Cubic at(s, h);
  for (int i = 0; i < lanes; ++i) {
    const Vec3 whole = (end[i] * from[i].back()).vector();
    now[i] = Quaternion::by(
                 at(Vec3(), rate(g.v_from, g.w_from, g.from, i), whole, rate(v, w, end_frame, i))) *
             from[i];
  }
}

}    // namespace raceway
