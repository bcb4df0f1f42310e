// SPDX-License-Identifier: GPL-2.0-or-later
// Load of a ball over a pit that is narrower than the contact patch (docs/theory, Flaws of a
// raceway). The strip of the patch over the pit, which would carry the fraction chi of the load,
// has an overlap that is reduced by the depth D. The remainder of the patch has the full overlap.
// The load is
//   Q/K = chi max(0, d - D)^1.5 + (1 - chi) d^1.5,    chi = 1.5 x - 0.5 x^3, x = sqrt(e/d)
// for d > e, and chi = 1 otherwise. d is the overlap without the pit, and e is the overlap at which
// the patch is as wide as the pit. The stored energy and its first and second derivatives with
// respect to d and D have closed-form expressions.
#pragma once

#include <cmath>

namespace raceway {

struct PitLoad {
  double energy;        // m^2.5, stored energy divided by K
  double load, side;    // m^1.5, derivatives of `energy` with respect to d and to -D
  double dd, dD, DD;    // m^0.5, second derivatives of `energy`
  double wide;          // m^2, negative derivative of `energy` with respect to sqrt(e)
};

namespace detail {
// Integrals over x of sqrt(x - D) and of (x - D)^1.5, divided by sqrt(x) and by x^1.5.
struct PitIntegrals {
  double half_1, half_3, whole_1, whole_3;
  PitIntegrals(double x, double D)
  {
    const double root = std::sqrt(x), rest = std::sqrt(x - D), both = root * rest,
                 log = std::log(root + rest);
    half_1 = both - D * log;
    half_3 = 2.0 * (log - rest / root);
    whole_1 = 0.25 * (2.0 * x - D) * both - 0.25 * D * D * log - D * half_1;
    whole_3 = half_1 - D * half_3;
  }
};
}    // namespace detail

// Returns the load over a pit. Preconditions: d > 0, D >= 0, e > 0.
inline PitLoad pit_load(double d, double D, double e)
{
  const double over = std::fmax(0.0, d - D), rest = std::sqrt(over);
  if (d <= e) {
    const double load = over * rest;
    return {0.4 * over * load, load, load, 1.5 * rest, -1.5 * rest, 1.5 * rest, 0.0};
  }
  const double root = std::sqrt(d), c = std::sqrt(e), x = c / root, c3 = c * e;
  const double share = 1.5 * x - 0.5 * x * x * x, falls = -0.75 * (x - x * x * x) / d;
  const double missing = d * root - over * rest;
  PitLoad p;
  p.load = d * root - share * missing;
  p.dd = 1.5 * root - falls * missing - 1.5 * share * (root - rest);
  p.dD = -1.5 * share * rest;
  const double at_e = std::fmax(0.0, e - D), from = std::fmax(e, D);
  p.energy = 0.4 * (at_e * at_e * std::sqrt(at_e) + d * d * root - e * e * c) -
             (0.75 * c * (d * d - e * e) - 0.5 * c3 * (d - e));
  p.side = at_e * std::sqrt(at_e);
  p.DD = 1.5 * std::sqrt(at_e);
  p.wide = 0.75 * (d * d - e * e) - 1.5 * e * (d - e);
  if (d > from) {
    const detail::PitIntegrals to(d, D), start(from, D);
    p.energy += 1.5 * c * (to.whole_1 - start.whole_1) - 0.5 * c3 * (to.whole_3 - start.whole_3);
    p.side += 1.5 * (1.5 * c * (to.half_1 - start.half_1) - 0.5 * c3 * (to.half_3 - start.half_3));
    p.wide += 1.5 * e * (to.whole_3 - start.whole_3) - 1.5 * (to.whole_1 - start.whole_1);
    const double begin = std::sqrt(from - D),
                 logs = std::log((root + rest) / (std::sqrt(from) + begin));
    const double quotient = 2.0 * (1.0 / from - 1.0 / d) / (rest / root + begin / std::sqrt(from));
    p.DD += 0.75 * (3.0 * c * logs - 0.5 * c3 * quotient);
  }
  return p;
}

}    // namespace raceway
