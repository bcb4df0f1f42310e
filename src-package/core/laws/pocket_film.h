// SPDX-License-Identifier: GPL-2.0-or-later
// Squeeze film between a ball and the wall of its cage pocket, which resists their relative motion.
//
// The oil forms a band of the height H around the ball, in a gap h = c (1 - e cos(theta)), where e
// is the displacement of the ball divided by the clearance c. As in a short bearing (DuBois and
// Ocvirk, NACA Report 1157, 1953), the line load is eta L^3 v cos/h^3 on the side that the ball
// approaches. It is zero on the other side, where the film cavitates. The integrals over half of
// the band are exact (substitution of Sommerfeld; Booker, J. Basic Eng. 87, 1965).
//
// The effective width L depends on the shape of the pocket. Close to the wall of a spherical pocket
// the oil also escapes along the band, and the force approaches that between two spheres, which is
// 6 pi eta v (R^2/c)^2/h (Reynolds' equation with p ~ 1/h^2). In a cylindrical pocket the gap
// widens with the distance y from the middle of the band to h + y^2/(2R), so the line load is
// 3 pi sqrt(2) eta v cos (R/h)^(3/2). Between these limits L is a fit. With it, the force is within
// 12 % of numerical solutions of Reynolds' equation (test_physics_pocket_film.py). All values are
// in SI units.
#pragma once

#include "../numbers/dual.h"
#include "cage_drag.h"

#include <cmath>

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

// Coefficients of the force on the ball, -(spring x + damper v), in N/m and N s/m. x and v are the
// position and velocity of the ball in its pocket.
template <class T> struct SqueezeFilm {
  T spring, damper;
};

// Returns these coefficients as functions of the products x.x (m^2), x.v (m^2/s) and v.v (m^2/s^2).
// In a cylindrical pocket, x and v have no component along the axis of the pocket.
template <class T>
RACEWAY_INLINE SqueezeFilm<T> squeeze_film(const PocketFilm &p, const T &xx, const T &xv,
                                           const T &vv)
{
  const double pi = 3.14159265358979323846, c = p.clearance;
  const T off = square_root(T(xx + 1e-12 * c * c)), speed = square_root(T(vv + 1e-24));
  T e = off / c;
  e = where(e < most_eccentric, e, most_eccentric);
  // cosine of the angle between motion and displacement, square of its sine
  const T q = xv / (off * speed), s2 = 1.0 - q * q;
  const T e2 = e * e, m = 1.0 - e2, root = square_root(m), over = 1.0 / (1.0 - e2 * s2);
  const T turn = pi + 2.0 * arctangent(T(e * q / root));
  const T twice = e * root * q * (2.0 * s2 - 1.0 - e2 * s2) * over * over;
  // integrals of cos^2, sin cos and sin^2 over (1 - e cos)^3; that of sin cos is divided by the
  // sine of the angle
  const T along = ((0.5 + e2) * turn + 4.0 * e * root * q * over + twice) / (m * m * root),
          mixed = 2.0 * e / m * (over - q * q * over * over),
          across = (0.5 * turn - twice) / (m * root);
  const T k = film_width_cubed(p, e) * (p.viscosity * p.radius / (c * c * c));
  const T damper = k * (mixed * q + across);
  return {(k * (along * q + mixed * s2) - damper * q) * speed / off, damper};
}

}    // namespace raceway
