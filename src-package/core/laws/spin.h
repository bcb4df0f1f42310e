// SPDX-License-Identifier: GPL-2.0-or-later
// Couple that opposes spin about the contact normal (docs/tribology, Spin): (3/8) mu Q a E for pure
// spin under Coulomb's law, where E is the complete elliptic integral for the ellipse.
//
// If the contact also slides, the couple at small spin is proportional to the spin. Integration
// over the ellipse by Gauss points (tests/references/spin.py) gives the width of this range: omega
// a = 0.78 s_e with differential slip, omega a = 1.9 s with gross sliding. Conversely, spin reduces
// the couple of differential slip by the factor 1 - 1.35 (omega a/s_e)^2, except for the part that
// balances the power of the force at the slip of free rolling, without which the contact would
// supply power. Moment and power agree with the integration within 5 % of mu Q a and mu Q s_e.
#pragma once

#include "../numbers/lane.h"

namespace raceway {

// Returns the couple of pure spin (N m) from mu Q and the Hertz constants. Since K, a and b are
// known, E does not have to be evaluated:
//   (3/8) mu Q a E = mu Q sqrt(delta) pi E' a^2 b^2 (1/R_x + 1/R_y)/(16 K),
// with a and b divided by sqrt(delta).
template <class T>
RACEWAY_INLINE T spin_couple(const T &limit, double modulus, const T &root, const T &a, const T &b,
                             const T &K, const T &rolling_radius, double transverse_radius)
{
  const T ab = a * b, curvature = 1.0 / rolling_radius + 1.0 / transverse_radius;
  return limit * root * (3.14159265358979323846 / 16.0 * modulus) * ab * ab * curvature / K;
}

// Returns the couple of pure spin (N m) from a known E.
inline double pure_spin_couple(double limit, double a, double E) { return 0.375 * limit * a * E; }

// Fitted constants: the values of omega a/s_e and of omega a/s up to which the couple increases,
// and the coefficient in the reduction of the differential-slip couple
constexpr double spin_width = 0.78, spin_loss = 1.35, spin_slide = 1.9;

// Returns a speed (m/s) from omega a, the width s_e and the sliding speed. The spin couple is that
// of pure spin times omega a divided by this speed.
template <class T> RACEWAY_INLINE T spin_growth(const T &speed, const T &width, const T &slide)
{
  const T slip = spin_slide * slide, wide = spin_width * width;
  const T least = where(wide > slip, wide, slip);
  return where(speed > least, speed, least);
}

// Returns the factor by which spin reduces the couple of differential slip.
template <class T> RACEWAY_INLINE T slip_beside_spin(const T &speed, const T &width)
{
  const T x = speed / width, rest = 1.0 - spin_loss * x * x;
  return where(rest > 0.0, rest, 0.0);
}

}    // namespace raceway
