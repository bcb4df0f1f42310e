// SPDX-License-Identifier: GPL-2.0-or-later
// Normal damping of a ball on a raceway (docs/theory, Normal damping; Farah 2020 eqs 1, 4, 5).
//
//   F_n = max(0, Q + C d(overlap)/dt),  C = C_hyst + C_fluid   (Kelvin-Voigt, no adhesion)
//   C_hyst  = 1.5 alpha_e Q                                    (Hunt & Crossley 1975)
//   C_fluid = 3 pi eta/sqrt(2) l (R/h)^1.5                     (Walford & Stone 1983)
// In the printed equation, l is the semi-axis a and R is the ball radius. A derivation from the
// squeezing of a half film per unit length gives l = 2a and R = R_x instead (errata, eq 5). Both
// forms are available. h has a lower limit, because the film thickness of a contact at rest is
// zero.
#pragma once

#include "../numbers/lane.h"

namespace raceway {

// Returns the prefactor in C_fluid = prefactor * a * h^-1.5, N s/m^0.5.
inline double film_damping_prefactor(double viscosity, double radius, double length_factor)
{
  const double pi = 3.14159265358979323846;
  return 3.0 * pi * viscosity / std::sqrt(2.0) * length_factor * radius * std::sqrt(radius);
}

template <class T>
RACEWAY_INLINE T film_damping(const T &prefactor, const T &a, const T &h, double floor)
{
  const T film = where(h > floor, h, floor);
  return prefactor * a / (film * square_root(film));
}

template <class T> RACEWAY_INLINE T hysteretic_damping(double alpha_e, const T &load)
{
  return 1.5 * alpha_e * load;
}

}    // namespace raceway
