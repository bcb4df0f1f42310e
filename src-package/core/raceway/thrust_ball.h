// SPDX-License-Identifier: GPL-2.0-or-later
// Equilibrium of a ball in a bearing under pure thrust, including its centrifugal force, for rigid
// rings and dry Hertz contacts (docs/tribology, Start of the balls).
//
// In the axial direction, both contacts carry the part f of the thrust that acts on the ball: Q_k
// sin(alpha_k) = f. In the radial direction, the outer contact also carries the centrifugal force
// F: Q_o cos(alpha_o) = Q_i cos(alpha_i) + F. The distance of each centre of curvature from the
// ball's centre is the sum of the slack and the compression. The radial components of both
// distances add up to the radial distance between the centres, which the thrust does not change.
// This sum decreases with alpha_i, so the root is unique.
#pragma once

#include "raceway.h"

namespace raceway {

struct ThrustContact {
  double angle = 0.0, load = 0.0, compression = 0.0;    // rad, N, m
  RacewayConstants constants = {};
};

inline ThrustContact thrust_contact(const Raceway &p, double angle, double load)
{
  ThrustContact c = {
      angle, load, 0.0,
      raceway_constants(p.groove, p.pitch_radius, p.material, p.model, std::cos(angle))};
  c.compression = c.constants.unit * std::pow(load, 2.0 / 3.0);
  return c;
}

struct ThrustBall {
  bool held = false;    // false: the ball climbs out of the grooves
  ThrustContact inner, outer;
  double path = 0.0;    // m, radius of the circle on which the ball's centre moves
};

// Computes the equilibrium of a ball under its part `share` (N, above 0) of the thrust and a
// centrifugal force (N). In each raceway, only the groove, the materials and pitch_radius have to
// be set.
inline ThrustBall thrust_ball(const Raceway &inner, const Raceway &outer, double share,
                              double centrifugal)
{
  const double apart = inner.groove.centre_circle() - outer.groove.centre_circle();
  ThrustBall ball;
  const auto line = [](const Raceway &p, const ThrustContact &c) {
    return (p.groove.slack() + c.compression) * std::cos(c.angle);
  };
  const auto beyond = [&](double angle) {
    const double outer_angle = std::atan2(share, share / std::tan(angle) + centrifugal);
    ball.inner = thrust_contact(inner, angle, share / std::sin(angle));
    ball.outer = thrust_contact(outer, outer_angle, share / std::sin(outer_angle));
    return line(inner, ball.inner) + line(outer, ball.outer) - apart;
  };
  double low = 1.0e-3, high = 1.5;    // rad
  if (!(beyond(low) > 0.0) || !(beyond(high) < 0.0)) return ball;
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) break;
    if (beyond(middle) > 0.0) low = middle;
    else high = middle;
  }
  ball.held = true;
  ball.path = outer.groove.centre_circle() + line(outer, ball.outer);
  return ball;
}

}    // namespace raceway
