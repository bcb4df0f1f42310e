// SPDX-License-Identifier: GPL-2.0-or-later
// Squeeze film between a ball and the wall of its cage pocket, which resists their relative motion
// (half_film.h). The oil forms a band of the height H around the ball, and the clearance of the
// pocket is c.
//
// The effective width L depends on the shape of the pocket. Close to the wall of a spherical pocket
// the oil also escapes along the band, and the force approaches that between two spheres, which is
// 6 pi eta v (R^2/c)^2/h (Reynolds' equation with p ~ 1/h^2). In a cylindrical pocket the gap
// widens with the distance y from the middle of the band to h + y^2/(2R), so the line load is
// 3 pi sqrt(2) eta v cos (R/h)^(3/2). Between these limits L is a fit. With it, the force is within
// 12 % of numerical solutions of Reynolds' equation (test_physics_pocket_film.py). All values are
// in SI units.
#pragma once

#include "half_film.h"

namespace raceway {

struct PocketFilm {
  double radius = 0.0, clearance = 0.0;    // radius of the ball and clearance in the pocket, m
  double height = 0.0;                     // m, height of the band of oil
  double viscosity = 0.0;                  // Pa s, times the fraction of the gap that is filled
  bool spherical = false;
};

// Returns the cube of the effective width L of the band (m^3) at the eccentricity ratio e.
template <class T> RACEWAY_INLINE T film_width_cubed(const PocketFilm &p, const T &e)
{
  const double pi = 3.14159265358979323846, R = p.radius, c = p.clearance;
  const T open = 1.0 - e, root = square_root(open), opened = open * root;
  if (!p.spherical) {
    // limits: exact for e = 0; for e -> 1, the integrals over the line loads with h^-3 and h^-3/2
    // are sqrt(2) (3 pi/8) (1 - e)^(-5/2) and 2 sqrt(2)/(1 - e)
    const double wide = 3.0 * pi * std::sqrt(2.0 * R * c) * R * c / (1.0 + 3.0 * c / R);
    return wide * opened * (1.0 + (16.0 / (3.0 * pi) - 1.0) * (1.0 - root));
  }
  const double H3 = p.height * p.height * p.height;
  const T spheres = 16.0 / std::sqrt(2.0) * R * R * R * opened;
  return H3 * spheres / (H3 + spheres + 0.7 * square_root(T(H3 * spheres)));
}

// Returns the film as a function of the products x.x (m^2), x.v (m^2/s) and v.v (m^2/s^2) of the
// position x and the velocity v of the ball in its pocket. In a cylindrical pocket, x and v have no
// component along the axis of the pocket.
template <class T>
RACEWAY_INLINE HalfFilm<T> squeeze_film(const PocketFilm &p, const T &xx, const T &xv, const T &vv)
{
  const double c = p.clearance;
  const Eccentricity<T> at = eccentricity(c, xx);
  const T k = film_width_cubed(p, at.ratio) * (p.viscosity * p.radius / (c * c * c));
  return half_film(k, at, xv, vv);
}

}    // namespace raceway
