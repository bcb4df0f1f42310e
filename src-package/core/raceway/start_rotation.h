// SPDX-License-Identifier: GPL-2.0-or-later
// Initial rotation of the balls in a bearing, chosen such that the loss due to spin under pure
// thrust is smallest (docs/tribology, Start of the balls).
#pragma once

#include "../laws/differential_slip.h"
#include "../laws/spin.h"
#include "../laws/start_attitude.h"
#include "thrust_ball.h"

namespace raceway {

struct StartingBall {
  double radius, mass;                // m, kg
  double path;                        // m, initial radius of the circle on which the ball's centre
                                      // moves
  double orbit;                       // rad/s, orbital speed, from which the centrifugal force is
                                      // computed
  double inner_speed, outer_speed;    // rad/s, of the rings
  double thrust;    // N, axial load that this ball carries out of the axial force on the inner
                    // ring; 0: unknown
  // rad, contact angle on both raceways at the initial position; positive if a thrust on the inner
  // ring along +e closes the contacts
  double angle;
};

// Returns the spin data of a contact that rolls at the speed `roll` (rad/s). The friction
// coefficients of both raceways are assumed to be equal.
inline SpinContact spin_contact(const Raceway &p, const ThrustContact &c, double sense,
                                double ring_speed, double roll)
{
  const RacewayConstants &k = c.constants;
  const double root = std::sqrt(c.compression), a = k.a * root,
               deformed = deformed_radius(p.groove.groove_radius, p.groove.ball_radius);
  return {sense * c.angle, ring_speed,
          spin_couple(c.load, p.material.Eprime(), root, k.a, k.b, k.K,
                      p.rolling_radius(std::cos(c.angle)), p.transverse_radius()),
          0.5 * spin_width * std::fabs(roll) * a / deformed};
}

// Returns the rotation at the contact angles and loads that result from the thrust. If there is no
// thrust or the grooves cannot carry it, returns the rotation for a small load and the contact
// angle of the initial position.
inline BallRotation start_rotation(Raceway inner, Raceway outer, const StartingBall &b)
{
  for (Raceway *p : {&inner, &outer}) {
    p->groove.ball_radius = b.radius;
    p->pitch_radius = b.path;
  }
  constexpr double small = 1.0;    // N
  const double centrifugal = b.mass * b.path * b.orbit * b.orbit;
  ThrustBall ball;
  if (b.thrust != 0.0) ball = thrust_ball(inner, outer, std::fabs(b.thrust), centrifugal);
  if (!ball.held)
    ball = {false, thrust_contact(inner, std::fabs(b.angle), small),
            thrust_contact(outer, std::fabs(b.angle), small), b.path};
  const double sense = std::copysign(1.0, ball.held ? b.thrust : b.angle);
  const auto at = [&](const Raceway &p, const ThrustContact &c, double speed) {
    return spin_contact(p, c, sense, speed, (speed - b.orbit) * ball.path / b.radius);
  };
  return start_attitude(at(inner, ball.inner, b.inner_speed), at(outer, ball.outer, b.outer_speed),
                        b.radius, ball.path);
}

}    // namespace raceway
