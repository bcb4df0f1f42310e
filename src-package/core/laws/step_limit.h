// SPDX-License-Identifier: GPL-2.0-or-later
// Largest stable step of velocity Verlet if the force depends on the half-step velocity.
//
// For m x'' = -k x - c x', one step gives v' = (1 - h c/m) v - (h k/m) x, x' = x + h v'. The two
// multipliers of the step lie inside the unit circle if h^2 k/m + 2 h c/m < 4. Hence
//   h_max = (sqrt(c^2 + 4 k m) - c)/k, or 2 sqrt(m/k) if c = 0, or 2 m/c if k = 0.
//
// A Maxwell branch (k_m, tau), whose force is advanced by an exact step, adds one multiplier. At
// the stability limit one of the multipliers is -1:
//   h^2 k/m + 2 h c/m + (2 h/m) k_m tau tanh(h/(2 tau)) = 4.
// Since tanh(x) is below x and below 1, the branch acts at most like a spring k_m and at most like
// a dashpot k_m tau. The larger of the two step limits is therefore safe.
#pragma once

#include <algorithm>
#include <cmath>

namespace raceway {

// Sums over the film branches of a body.
struct FilmBranches {
  double stiffness = 0.0, dashpot = 0.0;    // N/m, N s/m, sums of k_m and of k_m tau

  void add(double k_m, double rate)    // rate = 1/tau, 1/s
  {
    stiffness += k_m;
    if (k_m > 0.0) dashpot += k_m / rate;    // infinite at rest
  }
};

// Returns the largest step (s) for k in N/m, c in N s/m and m in kg. It is infinite if there is
// neither a spring nor a damper. The formula is written in a form that remains accurate as k -> 0.
inline double verlet_step_limit(double k, double c, double m)
{
  const double q = c + std::sqrt(c * c + 4.0 * k * m);
  return q > 0.0 ? 4.0 * m / q : HUGE_VAL;
}
inline double verlet_step_limit(double k, double c, double m, const FilmBranches &film)
{
  if (!(film.stiffness > 0.0)) return verlet_step_limit(k, c, m);
  return std::max(verlet_step_limit(k + film.stiffness, c, m),
                  verlet_step_limit(k, c + film.dashpot, m));
}

}    // namespace raceway
