// SPDX-License-Identifier: GPL-2.0-or-later
// Dimensions of a bearing, derived from its usual data in the same way as in raceway.inputs. All
// values are in SI units.
//
// The pitch diameter is the diameter of the circle on which the ball centres lie when the balls
// touch both raceways at the contact angle. A contact angle above 0 therefore determines the
// clearance.
#pragma once

#include <cmath>

namespace raceway {

struct UsualData {
  double balls, ball_diameter, pitch_diameter;
  double contact_angle;    // rad

  // Return the radius of a raceway (m), measured at the bottom of a groove of radius `groove`.
  double inner_radius(double groove) const { return 0.5 * pitch_diameter - groove + reach(groove); }
  double outer_radius(double groove) const { return 0.5 * pitch_diameter + groove - reach(groove); }
  // Returns the diameter of cage balls that gives each ball the clearance `play` along the pitch
  // circle.
  double cage_ball_diameter(double play) const
  {
    return 2.0 * pitch_diameter * std::sin(0.5 * M_PI / balls) - ball_diameter - play;
  }

 private:
  double reach(double groove) const
  {
    return (groove - 0.5 * ball_diameter) * std::cos(contact_angle);
  }
};

// Approximation of the inner ring by a hollow cylinder. Its shoulders are assumed to be 0.18 ball
// diameters above the bottom of the groove.
struct RingCylinder {
  double bore_diameter, width, outer_radius;

  static double shoulder(double inner_radius, double ball_diameter)
  {
    return inner_radius + 0.18 * ball_diameter;
  }
  double mass(double density) const
  {
    return density * M_PI * (outer_radius * outer_radius - bore2()) * width;
  }
  // Return the moments of inertia about the axis and about a diameter (kg m^2) for a given mass
  // (kg).
  double inertia(double mass) const { return 0.5 * mass * (outer_radius * outer_radius + bore2()); }
  double inertia_t(double mass) const { return 0.5 * inertia(mass) + mass * width * width / 12.0; }

 private:
  double bore2() const { return 0.25 * bore_diameter * bore_diameter; }
};

}    // namespace raceway
