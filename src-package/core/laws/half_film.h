// SPDX-License-Identifier: GPL-2.0-or-later
// Force of the oil film of a short bearing, which fills a gap h = c (1 - e cos(theta)) between a
// body and the wall around it. e is the displacement of the body divided by the clearance c.
//
// On the side that the body approaches, the line load is eta L^3 v cos/h^3 (DuBois and Ocvirk, NACA
// Report 1157, 1953). It is zero on the other side, where the film cavitates. v is the velocity of
// the body relative to axes that rotate at half the sum of the speeds of both surfaces. The
// integrals over half of the gap are exact (substitution of Sommerfeld; Booker, J. Basic Eng. 87,
// 1965). All values are in SI units.
#pragma once

#include "../numbers/dual.h"

#include <cmath>

namespace raceway {

// Largest eccentricity ratio for which the film law is used; beyond it the surfaces touch.
constexpr double most_eccentric = 0.99;

// Coefficients of the force on the body, -(spring x + damper v), in N/m and N s/m. x and v are its
// position and velocity.
template <class T> struct HalfFilm {
  T spring, damper;
};

// The displacement in a gap.
template <class T> struct Eccentricity {
  T off;      // m
  T ratio;    // to the clearance, at most `most_eccentric`
};

// Returns the displacement for the product x.x (m^2).
template <class T> RACEWAY_INLINE Eccentricity<T> eccentricity(double clearance, const T &xx)
{
  const T off = square_root(T(xx + 1e-12 * clearance * clearance)), e = off / clearance;
  return {off, where(e < most_eccentric, e, most_eccentric)};
}

// Returns the coefficients as functions of the products x.v (m^2/s) and v.v (m^2/s^2). k is eta L^3
// R/c^3 for a gap of the radius R, N s/m.
template <class T>
RACEWAY_INLINE HalfFilm<T> half_film(const T &k, const Eccentricity<T> &at, const T &xv,
                                     const T &vv)
{
  const double pi = 3.14159265358979323846;
  const T &off = at.off, &e = at.ratio;
  const T speed = square_root(T(vv + 1e-24));
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
  const T damper = k * (mixed * q + across);
  return {(k * (along * q + mixed * s2) - damper * q) * (vv / speed) / off, damper};
}

}    // namespace raceway
