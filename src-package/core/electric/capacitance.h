// SPDX-License-Identifier: GPL-2.0-or-later
// Electrical capacitance of a lubricated Hertz contact (docs/theory, Capacitance; Farah 2020 eqs 8,
// 10-12).
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

constexpr double vacuum_permittivity = 8.8541878128e-12;    // F/m, CODATA 2018

// Returns rho/rho_0 at the pressure p (Pa), eq 11 (Dowson & Higginson 1966).
template <class T> RACEWAY_INLINE T density_ratio(const T &p)
{
  return (0.59e9 + 1.34 * p) / (0.59e9 + p);
}

// Returns the relative permittivity at the pressure p (Pa), computed from its value at ambient
// pressure by eq 10 (Clausius-Mossotti), where (eps - 1)/(eps + 2) is proportional to the density.
// Precondition: eps_ambient >= 1.
template <class T> RACEWAY_INLINE T permittivity_at(double eps_ambient, const T &p)
{
  const T c = (eps_ambient - 1.0) / (eps_ambient + 2.0) * density_ratio(p);
  return (1.0 + 2.0 * c) / (1.0 - c);
}

// Returns the mean relative permittivity over a Hertz contact with the maximum pressure p (Pa).
// With q = pressure/p, the fraction of the area at pressures above q p is 1 - q^2, and by eqs 10
// and 11 eps(q p) = eps_ambient + slope p q/(1 + r q).
template <class T> RACEWAY_INLINE T mean_permittivity(double eps_ambient, const T &p)
{
  const double c = (eps_ambient - 1.0) / (eps_ambient + 2.0), reference = 0.59e9;
  const double slope = 1.02 * c / ((1.0 - c) * (1.0 - c) * reference);
  const T r = (1.0 - 1.34 * c) / ((1.0 - c) * reference) * p;
  // the integral of 2 q^2/(1 + r q) from 0 to 1, computed from a series where the difference would
  // suffer from cancellation
  const auto small = magnitude(r) < 0.03;
  const T series =
      2.0 * (1.0 / 3 -
             r * (1.0 / 4 -
                  r * (1.0 / 5 - r * (1.0 / 6 - r * (1.0 / 7 - r * (1.0 / 8 - r * (1.0 / 9)))))));
  const T safe = where(small, T() + 1.0, r);
  const T closed = (safe * (safe - 2.0) + 2.0 * logarithm(T(1.0 + safe))) / (safe * safe * safe);
  return eps_ambient + slope * p * where(small, series, closed);
}

// Returns the capacitance (F) of parallel plates with the area of the Hertz ellipse, eq 8. a and b
// are the semi-axes (m), and h is the central film thickness (m).
template <class T>
RACEWAY_INLINE T contact_capacitance(const T &eps_r, const T &a, const T &b, const T &h)
{
  return vacuum_permittivity * eps_r * 3.14159265358979323846 * a * b / h;
}

// Returns the mean of 1/gap between rough surfaces divided by 1/h, for a gap with a gamma
// distribution: Lambda^2/(Lambda^2 - 1), Lambda = h/sigma. The argument is sigma/h. Below Lambda =
// 2.5 the factor is constant, because closer surfaces are considered to touch.
template <class T> RACEWAY_INLINE T rough_film_factor(const T &sigma_over_h)
{
  const T s = where(sigma_over_h > 0.4, 0.4, sigma_over_h);
  return 1.0 / (1.0 - s * s);
}

// Returns the capacitance (F) of a ball's inner and outer contacts in series, i.e. one term of eq
// 12. It is 0 if the ball has no contact on one side.
inline double series_capacitance(double inner, double outer)
{
  return inner > 0.0 && outer > 0.0 ? inner * outer / (inner + outer) : 0.0;
}

}    // namespace raceway
