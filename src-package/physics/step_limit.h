// SPDX-License-Identifier: GPL-2.0-or-later
// Largest stable step of velocity Verlet with a force that depends on the half-step velocity.
//
// For m x'' = -k x - c x' that scheme advances v' = (1 - h c/m) v - (h k/m) x, x' = x + h v'; its
// two multipliers stay inside the unit circle when h^2 k/m + 2 h c/m < 4. Hence
//   h_max = (sqrt(c^2 + 4 k m) - c)/k,  2 sqrt(m/k) without damper, 2 m/c without spring.
#ifndef RACEWAY_STEP_LIMIT_H
#define RACEWAY_STEP_LIMIT_H

#include <cmath>

namespace raceway {

// k N/m, c N s/m, m kg; infinite where nothing acts. Written so that k -> 0 is exact.
inline double verlet_step_limit(double k, double c, double m)
{
  const double q = c + std::sqrt(c * c + 4.0 * k * m);
  return q > 0.0 ? 4.0 * m / q : HUGE_VAL;
}

}    // namespace raceway

#endif
