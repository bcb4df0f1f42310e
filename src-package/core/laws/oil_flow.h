// SPDX-License-Identifier: GPL-2.0-or-later
// Oil that flows through a bearing and carries heat away (docs/heat). SI units, temperatures in
// degrees C.
#ifndef RACEWAY_OIL_FLOW_H
#define RACEWAY_OIL_FLOW_H

#include <cmath>

namespace raceway {

// Heat transfer coefficient (W/(m^2 K)) between flowing oil and the surfaces of a bearing, as at
// the distance x from the leading edge of a plate in laminar flow of the speed u:
// h = 0.332 k Pr^(1/3) sqrt(u/(nu x)), Pr = eta c_p/k (Pohlhausen). Here x is the pitch diameter
// (m) and u a third of the speed of the balls on the pitch circle (Harris, Rolling Bearing
// Analysis, after Eckert; from memory, unchecked). `orbit` (rad/s) is the speed of the balls around
// the bearing.
inline double oil_convection(double conductivity, double heat_capacity, double density,
                             double viscosity, double orbit, double pitch_diameter)
{
  const double prandtl = viscosity * heat_capacity / conductivity,
               speed = std::fabs(orbit) * 0.5 * pitch_diameter / 3.0;
  return 0.332 * conductivity * std::cbrt(prandtl) *
         std::sqrt(speed * density / (viscosity * pitch_diameter));
}

// Surfaces (m^2) that oil wets: the balls, and cylinders of the raceways' radii and the bearing's
// width (m).
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

// The oil between inlet and outlet, at one temperature: it mixes, and its mass is negligible.
struct OilFlow {
  static constexpr int surfaces = 3;    // inner ring, balls, outer ring
  double flow = 0.0;                    // W/K, mass flow times heat capacity; 0: the oil stays
  double inlet = 20.0;                  // C
  double wetted[surfaces] = {};         // m^2
  double convection = 0.0;              // W/(m^2 K)

  bool flows() const { return flow > 0.0; }
  double conductance(int surface) const { return convection * wetted[surface]; }    // W/K
  double total() const                                                              // W/K
  {
    return flow + convection * (wetted[0] + wetted[1] + wetted[2]);
  }
  // C, of the oil between surfaces at these temperatures, with `heat` (W) generated in it
  double outlet(const double *surface, double heat) const
  {
    double sum = flow * inlet + heat;
    for (int i = 0; i < surfaces; ++i) sum += conductance(i) * surface[i];
    return sum / total();
  }
};

}    // namespace raceway

#endif
