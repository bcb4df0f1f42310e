// SPDX-License-Identifier: GPL-2.0-or-later
// Heat transfer in a bearing (docs/heat): conductances and thermal expansion. Values are in SI
// units and temperatures in degrees C.
#pragma once

#include <cmath>

namespace raceway {

// Properties of bearing steel
constexpr double steel_conductivity = 46.0;    // W/(m K)
constexpr double steel_density = 7850.0;       // kg/m^3
constexpr double steel_heat = 460.0;           // J/(kg K)
constexpr double steel_expansion = 12e-6;      // 1/K

// Thermal properties of the balls relative to those of the steel rings.
struct BallHeat {
  double effusivity = 1.0;    // sqrt(k rho c)
  double expansion = 1.0;     // coefficient of thermal expansion

  // Returns the fraction of the heat generated in a contact that enters the ball: both surfaces
  // pass through the contact in the same time, so that half-spaces of equal temperature take up
  // heat in proportion to their effusivities.
  double share() const { return effusivity / (1.0 + effusivity); }
};

inline double effusivity_of_balls(double conductivity, double density, double heat_capacity)
{
  return std::sqrt(conductivity * density * heat_capacity /
                   (steel_conductivity * steel_density * steel_heat));
}

// Returns the conductance (W/K) of a contact ellipse through which both surfaces move at the speed
// u (m/s). Each point conducts into two half-spaces for the time 2b sqrt(1 - z^2)/u, where z is the
// position across the rolling direction divided by a. The prefactor is the integral of (1 -
// z^2)^(1/4) over z from 0 to 1, sqrt(pi) G(5/4)/(2 G(7/4)). Half-spaces with the effusivities e_1
// and e_2 conduct like two with 2 e_1 e_2/(e_1 + e_2). The formula was derived for this package and
// is valid for u b rho c/(2 k) > 5, which holds in every rotating bearing.
inline double contact_conductance(double a, double b, double u, const BallHeat &ball)
{
  constexpr double integral = 0.8740191847640399;
  constexpr double property = steel_conductivity * steel_density * steel_heat;
  return 2.0 * ball.share() * integral * 2.0 * a *
         std::sqrt(2.0 * property * b * u / 3.14159265358979323846);
}

// Returns the conductance (W/K) of the seats and housing of a radial bearing with the given
// dimensions (m) under the reference conditions of ISO 15312, W_s = q_r A_r/50 K with A_r = pi B (D
// + d). q_r is 0.016 W/mm^2 up to 50 000 mm^2, and decreases with A_r^-0.34 above (from memory,
// unchecked).
inline double iso_15312_conductance(double bore, double outside, double width)
{
  const double area = 3.14159265358979323846 * width * (outside + bore), large = area / 0.05;
  return 0.016e6 * area / 50.0 * (large > 1.0 ? std::pow(large, -0.34) : 1.0);
}

// Returns the change in diametral clearance (m) due to temperature rises (K) of the inner ring, the
// balls and the outer ring, for the given radii of raceways and balls (m).
inline double clearance_change(double inner_radius, double outer_radius, double ball_radius,
                               double inner, double balls, double outer, const BallHeat &ball)
{
  return -2.0 * steel_expansion *
         (inner_radius * inner + 2.0 * ball_radius * (ball.expansion * balls) -
          outer_radius * outer);
}

}    // namespace raceway
