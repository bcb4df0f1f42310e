// SPDX-License-Identifier: GPL-2.0-or-later
// Differential slip (Heathcote slip) of a ball in its groove under Coulomb's law, in closed form
// (docs/tribology, Differential slip, has the derivation).
//
// Ball and ring roll on one another at Omega (rad/s, about w). The contact surface is curved across
// the groove with the radius R_d = 2 r_c R_b/(r_c + R_b), so the sliding speed along rolling is
//   s(z) = s - Omega z^2/(2 R_d),  s_e = |Omega| a^2/(2 R_d) from the centre to the edge z = a.
// If the slip along rolling at the centre is s, and t0 = sqrt(s/s_e) is in [0, 1], then
//   F/(mu Q) = 3 t0 - t0^3 - 1,  C/(mu Q a^2/(2 R_d)) = t0^3 - 3/5 t0^5 - 1/5,
// Outside this range, F and C keep the values they have at t0 = 0 or 1. The power dissipated in the
// contact is F s - C |Omega|. In rolling without slip, Omega = u/R_x, where u is the entrainment
// speed.
#pragma once

#include "../numbers/lane.h"

namespace raceway {

constexpr double free_root = 0.34729635533386070;      // 2 sin(pi/18): F = 0
constexpr double free_part = free_root * free_root;    // slip in free rolling divided by s_e
// load-weighted mean sliding speed in free rolling, divided by s_e
constexpr double free_speed = 0.2 + free_part * free_root * (0.6 * free_part - 1.0);
constexpr double free_lean = 1.5 * (1.0 - free_part) / free_root;    // s_e dF/ds/(mu Q) there

// Returns the radius of curvature of the contact surface across the groove, m.
inline double deformed_radius(double groove, double ball)
{
  return 2.0 * groove * ball / (groove + ball);
}

// Returns the slip s_e at the edge, m/s.
inline double edge_slip(double speed, double a, double deformed, double rolling_radius)
{
  return std::fabs(speed) * a * a / (2.0 * deformed * rolling_radius);
}

// Returns t0 for the slip `off`, which is measured relative to free rolling and in units of s_e.
template <class T> RACEWAY_INLINE T slip_root(const T &off)
{
  const T q = free_part + off;
  return square_root(T(where(q > 0.0, where(q < 1.0, q, 1.0), 0.0)));
}

// Returns the secant of the slip law: F/(mu Q) divided by the slip `off`.
template <class T> RACEWAY_INLINE T slip_secant(const T &off)
{
  const T q = free_part + off, t = slip_root(off);
  const T inside = (3.0 - t * t - t * free_root - free_part) / (t + free_root);
  const T beyond = 1.0 / magnitude(off);
  return where(q < 0.0, beyond, where(q > 1.0, beyond, inside));
}

// Returns F/(mu Q) at the slip `off`. The value is 1 or -1 if t0 would be outside its range.
template <class T> RACEWAY_INLINE T slip_force(const T &off)
{
  const T q = free_part + off;
  return where(q < 0.0, -1.0, where(q > 1.0, 1.0, slip_secant(off) * off));
}

// Returns t0 for a force F in units of mu Q. The root x of x^2 (3 - x) = 1 - F is 1 - t0. A
// polynomial in sqrt(1 - F) approximates the root within 1e-3; one step with four terms of the
// inverted Taylor series then gives it to rounding accuracy.
template <class T> RACEWAY_INLINE T force_root(const T &force)
{
  constexpr double least = 1e-24;    // lower limit of 1 - F that keeps the divisor x above 0
  const T rest = 1.0 - force, r = where(rest > least, where(rest < 2.0, rest, 2.0), least);
  const T q = square_root(r);
  const T x = q * (0.57692098 + q * (0.06107723 + q * (-0.00171489 + q * 0.01645284)));
  const T inverse = 1.0 / (3.0 * x * (2.0 - x)), s = (r - x * x * (3.0 - x)) * inverse;
  const T a = 3.0 * (1.0 - x) * inverse, b = -inverse, a2 = a * a;    // coefficients of e^2 and
                                                                      // e^3, divided by the slope
  const T e = s * (1.0 - s * (a - s * ((2.0 * a2 - b) - s * (5.0 * a * (a2 - b)))));
  return 1.0 - (x + e);
}

// Coulomb's law for sliding in both directions at once: mu Q divided by the secants of the law,
// which are speeds (m/s), and the factor by which the force along rolling has to be multiplied to
// give the force without sliding across, on which the couple depends. `along` is the slip relative
// to free rolling and `across` the slip across the groove, both in units of the width s_e.
template <class T> struct SlipBothWays {
  T sharing, speed_along, speed_across;
};
template <class T>
RACEWAY_INLINE SlipBothWays<T> slip_both_ways(const T &along, const T &across, const T &width)
{
  const T alone = slip_secant(along), cross = alone * across;
  const T sharing = square_root(T(1.0 + cross * cross));
  return {
      sharing, T(width * sharing / alone),
      T(width * square_root(T(along * along + across * across + 1.0 / (free_lean * free_lean))))};
}

// Returns C/(mu Q a^2/(2 R_d)).
template <class T> RACEWAY_INLINE T slip_couple(const T &t)
{
  const T cube = t * t * t;
  return cube - 0.6 * cube * t * t - 0.2;
}

}    // namespace raceway
