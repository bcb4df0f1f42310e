// SPDX-License-Identifier: GPL-2.0-or-later
// Electrical capacitance of a lubricated Hertz contact (docs/theory, Capacitance; Farah 2020 eqs 8,
// 10-12).
#ifndef RACEWAY_CAPACITANCE_H
#define RACEWAY_CAPACITANCE_H

#include "contact.h"

namespace raceway {

constexpr double vacuum_permittivity = 8.8541878128e-12;    // F/m, CODATA 2018

// rho/rho_0 at pressure p (Pa), eq 11 (Dowson & Higginson 1966).
template <class T> RACEWAY_INLINE T density_ratio(const T &p)
{
  return (0.59e9 + 1.34 * p) / (0.59e9 + p);
}

// Relative permittivity at pressure p from that at ambient pressure, eq 10 (Clausius-Mossotti):
// (eps - 1)/(eps + 2) is proportional to the density. Pre-condition 1 <= eps_ambient.
template <class T> RACEWAY_INLINE T permittivity_at(double eps_ambient, const T &p)
{
  const T c = (eps_ambient - 1.0) / (eps_ambient + 2.0) * density_ratio(p);
  return (1.0 + 2.0 * c) / (1.0 - c);
}

// Parallel plates of the Hertz ellipse, eq 8, F. a, b semi-axes (m), h central film (m).
template <class T>
RACEWAY_INLINE T contact_capacitance(const T &eps_r, const T &a, const T &b, const T &h)
{
  return vacuum_permittivity * eps_r * 3.14159265358979323846 * a * b / h;
}

// The central film (eq 9, at least `shortest`, m) and the capacitance (F) of a lubricated contact.
template <class T> struct FilmCapacitorT {
  T h_c, capacitance;
};
template <class T>
RACEWAY_INLINE FilmCapacitorT<T> film_capacitor(const RacewayPhysics &p, const ContactStateT<T> &c,
                                                double eps_ambient, double shortest)
{
  const RacewayConstantsT<T> k = p.law.at(c.cos_angle);
  const FilmPointT<T> at = film_point(c.entrainment, c.film_load);
  T h = film_thickness(k.film.central, at);
  if (p.factors.any) h = h * p.factors.of(at.ln_speed);
  const T h_c = where(h > shortest, h, shortest);
  const T eps = permittivity_at(eps_ambient, T(k.p * c.root));
  return {h_c, contact_capacitance(eps, T(k.a * c.root), T(k.b * c.root), h_c)};
}

// Inner and outer contact of a ball in series, one term of eq 12; a side without contact gives 0.
inline double series_capacitance(double inner, double outer)
{
  return inner > 0.0 && outer > 0.0 ? inner * outer / (inner + outer) : 0.0;
}

}    // namespace raceway

#endif
