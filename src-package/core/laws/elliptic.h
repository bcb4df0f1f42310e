// SPDX-License-Identifier: GPL-2.0-or-later
// Complete elliptic integrals by the arithmetic-geometric mean, and the quotient D(m) = (K - E)/m,
// which the Hertz equations require free of cancellation errors at small m. Source: Abramowitz &
// Stegun 17.6. The relative error is a few 1e-16 (tested against mpmath). Precondition: 0 <= m < 1.
// The input is the complementary parameter m1 = 1 - m, which is accurate near m = 1.
#pragma once

#include <cmath>

namespace raceway {

struct EllipticIntegrals {
  double K = 0.0;    // first kind
  double E = 0.0;    // second kind
  double D = 0.0;    // (K - E)/m, pi/4 at m = 0
};

inline EllipticIntegrals complete_elliptic(double m1)
{
  const double pi = 3.14159265358979323846;
  const double m = 1.0 - m1;
  double a = 1.0, b = std::sqrt(m1);
  // (K - E)/K = sum 2^(n-1) c_n^2, c_0^2 = m, c_(n+1) = (a_n - b_n)/2; dividing by m keeps D
  // accurate, because a_0 - b_0 = m/(1 + b_0).
  double c_over_m = 0.5 / (1.0 + b), power = 1.0, sum = 0.5;
  for (int n = 0; n < 60; ++n) {
    const double an = 0.5 * (a + b), bn = std::sqrt(a * b);
    const double term = power * c_over_m * c_over_m * m;    // 2^n c_(n+1)^2 / m
    sum += term;
    // c_(n+2) = c_(n+1)^2/(4 a_(n+2)), all relative to m
    const double an2 = 0.5 * (an + bn);
    c_over_m = c_over_m * c_over_m * m / (4.0 * an2);
    a = an;
    b = bn;
    power *= 2.0;
    if (term < 1e-18 * sum) break;
  }
  EllipticIntegrals v;
  v.K = pi / (a + b);
  v.D = v.K * sum;
  v.E = v.K - m * v.D;
  return v;
}

}    // namespace raceway
