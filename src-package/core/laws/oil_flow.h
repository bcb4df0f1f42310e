// SPDX-License-Identifier: GPL-2.0-or-later
// Oil that flows through a bearing and carries heat away (docs/heat). Values are in SI units and
// temperatures in degrees C.
#pragma once

#include <cmath>

namespace raceway {

// Returns the heat transfer coefficient (W/(m^2 K)) between flowing oil and the surfaces of a
// bearing. It equals the coefficient at the distance x from the leading edge of a plate in laminar
// flow at speed u: h = 0.332 k Pr^(1/3) sqrt(u/(nu x)), Pr = eta c_p/k (Pohlhausen). Here x is the
// pitch diameter (m), and u is a third of the speed of the balls on the pitch circle (Harris,
// Rolling Bearing Analysis, after Eckert; from memory, unchecked). `orbit` (rad/s) is the speed of
// the balls around the bearing.
inline double oil_convection(double conductivity, double heat_capacity, double density,
                             double viscosity, double orbit, double pitch_diameter)
{
  const double prandtl = viscosity * heat_capacity / conductivity,
               speed = std::fabs(orbit) * 0.5 * pitch_diameter / 3.0;
  return 0.332 * conductivity * std::cbrt(prandtl) *
         std::sqrt(speed * density / (viscosity * pitch_diameter));
}

// Areas of the surfaces wetted by oil (m^2), i.e. of the balls and of two cylinders that have the
// radii of the raceways and the width of the bearing (m).
struct WettedSurfaces {
  double inner, balls, outer;
};
inline WettedSurfaces wetted_surfaces(double inner_radius, double outer_radius, double ball_radius,
                                      double balls, double width)
{
  const double pi = 3.14159265358979323846;
  return {2.0 * pi * inner_radius * width, balls * 4.0 * pi * ball_radius * ball_radius,
          2.0 * pi * outer_radius * width};
}

// The oil between inlet and outlet, which is assumed to be perfectly mixed and to have no heat
// capacity of its own.
struct OilFlow {
  static constexpr int surfaces = 3;    // inner ring, balls, outer ring
  double flow = 0.0;                    // W/K, mass flow times heat capacity; 0: no flow
  double inlet = 20.0;                  // C
  double wetted[surfaces] = {};         // m^2
  double convection = 0.0;              // W/(m^2 K)

  bool flows() const { return flow > 0.0; }
  double conductance(int surface) const { return convection * wetted[surface]; }    // W/K
  double total() const                                                              // W/K
  {
    return flow + convection * (wetted[0] + wetted[1] + wetted[2]);
  }
  // Returns the temperature (C) of the oil between surfaces at the temperatures `surface` (C) if
  // the heat `heat` (W) is generated in the oil.
  double outlet(const double *surface, double heat) const
  {
    double sum = flow * inlet + heat;
    for (int i = 0; i < surfaces; ++i) sum += conductance(i) * surface[i];
    return sum / total();
  }
};

}    // namespace raceway
