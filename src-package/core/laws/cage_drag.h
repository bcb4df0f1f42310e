// SPDX-License-Identifier: GPL-2.0-or-later
// Drag of the oil on a one-piece cage: shear in the pockets, the film between the cage and its
// guiding land (half_film.h), and churning at the cage's faces (Schlichting, Boundary-Layer Theory:
// a disc that rotates in a fluid). All values are in SI units.
#pragma once

#include "../numbers/exp_log.h"
#include "half_film.h"

namespace raceway {

// Returns the couple on a ball that spins in its pocket, in N m per rad/s of relative spin about an
// axis normal to that of the pocket. The flow is a Couette flow over a band of height H (m) in the
// gap c (m), of which the fraction X is filled with oil. The couple is the integral of (eta w R
// |cos|/c) R |cos| over the band; the couple about the pocket's axis is twice as large.
inline double pocket_shear(double viscosity, double ball_radius, double height, double gap,
                           double filled)
{
  const double pi = 3.14159265358979323846;
  return filled * pi * viscosity * ball_radius * ball_radius * ball_radius * height / gap;
}

// The gap between a cage and the land of a ring that guides it.
struct LandGap {
  double radius = 0.0, clearance = 0.0;    // radius of the land and radial clearance, m
  double width = 0.0;                      // m, width of one land
  int lands = 2;                           // number of lands
  double viscosity = 0.0, filled = 1.0;    // oil viscosity, Pa s; fraction of the gap that is
                                           // filled with oil
};

// Returns Petroff's couple in an eccentric gap, in N m per rad/s of relative speed; e is the ratio
// of eccentricity to clearance.
inline double land_couple(const LandGap &g, double e)
{
  const double pi = 3.14159265358979323846, r = g.radius;
  const double cut = std::fmin(e, most_eccentric);
  return g.filled * 2.0 * pi * g.viscosity * r * r * r * (g.lands * g.width) /
         (g.clearance * std::sqrt(1.0 - cut * cut));
}

// Force (N) that the film exerts on the cage in the plane of the land.
template <class T> struct LandForce {
  T x, y;
};

// Returns the force of the film. x, y (m) and vx, vy (m/s) are the position and velocity of the
// cage relative to the land; `sum` is the sum of the angular speeds of the cage and the land,
// rad/s. A cage that whirls at half the sum is not supported.
template <class T>
LandForce<T> land_film(const LandGap &g, const T &x, const T &y, const T &vx, const T &vy,
                       double sum)
{
  const double c = g.clearance;
  const T k =
      g.lands * g.filled * g.viscosity * g.radius * g.width * g.width * g.width / (c * c * c);
  const T ux = vx + 0.5 * sum * y, uy = vy - 0.5 * sum * x;
  const HalfFilm<T> f =
      half_film(k, eccentricity(c, T(x * x + y * y)), T(x * ux + y * uy), T(ux * ux + uy * uy));
  return {-(x * f.spring + ux * f.damper), -(y * f.spring + uy * f.damper)};
}

// Returns the couple (N m) on both faces of a disc of radius r (m) that rotates at w (rad/s) in a
// mixture with oil of density rho (kg/m^3) and the oil fraction X. The couple is X rho w^2 r^5
// C_m/2, where C_m = 3.87/sqrt(Re) below Re = rho w r^2/eta = 3e5 and 0.146/Re^0.2 above.
inline double churning_couple(double share, double density, double viscosity, double radius,
                              double speed)
{
  const double w = std::fabs(speed);
  if (w == 0.0 || share == 0.0) return 0.0;
  const double reynolds = density * w * radius * radius / viscosity;
  const double C =
      reynolds < 3e5 ? 3.87 / std::sqrt(reynolds) : 0.146 * exponential(-0.2 * logarithm(reynolds));
  const double r2 = radius * radius;
  const double couple = 0.5 * share * density * w * w * r2 * r2 * radius * C;
  return speed < 0.0 ? -couple : couple;
}

}    // namespace raceway
