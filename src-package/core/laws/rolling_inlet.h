// SPDX-License-Identifier: GPL-2.0-or-later
// Fraction of the flooded rolling resistance that remains if the inlet is short (docs/tribology,
// Rolling resistance). The resisting force of the inlet follows from Reynolds's equation for a line
// contact with the central thickness h_c and the Hertzian gap in front of the contact, integrated
// up to a meniscus at m b:
//   f ~ integral from 1 to m of (h - h_c)/h^2 dX,  h = h_c + b^2 g(X)/(2 R_x),
//   g = X sqrt(X^2 - 1) - arcosh X,  X = x/b.
// The fraction of the flooded resistance depends on m and H = 2 R_x h_c/b^2. For the shortest inlet
// that still feeds the full film, m = 1 + 3.06 (H/2)^0.58 (Hamrock and Dowson), the fraction is
// 0.50 to 0.57 for H from 0.007 to 18. It is therefore limited to at least 1/2.
#pragma once

#include "../numbers/exp_log.h"

#include <cmath>

namespace raceway {

namespace detail {
// Returns the integral up to the meniscus at X = m, by Simpson's rule in s = ln(X - 1).
inline double inlet_integral(double m, double H)
{
  const double low = -14.0, high = std::log(m - 1.0);
  const int steps = 2 * static_cast<int>(std::ceil((high - low) / 0.1));
  const double width = (high - low) / steps;
  double sum = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const double over = std::exp(low + k * width), X = 1.0 + over;
    const double root = std::sqrt(over * (over + 2.0));
    // g suffers from cancellation near X = 1, so the first term of its series is used there
    const double g = over < 1e-4 ? 4.0 / 3.0 * std::sqrt(2.0) * over * std::sqrt(over)
                                 : X * root - std::log(X + root);
    const double weight = k == 0 || k == steps ? 1.0 : k % 2 ? 4.0 : 2.0;
    sum += weight * g / ((H + g) * (H + g)) * over;
  }
  return sum * width / 3.0;
}
}    // namespace detail

// Computes the fraction of the flooded resistance for the inlet length m at H by quadrature. m is
// in units of the semi-axis b along rolling and must be above 1.
inline double inlet_share(double m, double H)
{
  constexpr double far = 1e4;    // above this value the integrand is approximated by 1/X^2
  const double all = detail::inlet_integral(far, H) + 1.0 / far;
  return (m < far ? detail::inlet_integral(m, H) : all) / all;
}

// The approximation of the fraction that is used in contacts. It interpolates ln((1 - share)/share)
// as a function of ln H between five Chebyshev points. The result is accurate to 0.007 for H from
// 0.001 to 20 and is limited to at least 1/2.
struct RollingInlet {
  static constexpr int nodes = 5;
  static constexpr double low = -6.9, high = 3.0;    // range of ln H
  double node[nodes] = {}, slope[nodes] = {};        // nodes and coefficients of the polynomial in
                                                     // Newton form
  bool short_inlet = false;

  // length: inlet length in units of the semi-axis b; 0: flooded, 1: shortest inlet
  void prepare(double length)
  {
    short_inlet = length > 0.0;
    if (!short_inlet) return;
    for (int k = 0; k < nodes; ++k) {
      node[k] = 0.5 * (low + high) +
                0.5 * (high - low) * std::cos(3.14159265358979323846 * (k + 0.5) / nodes);
      const double share = length > 1.0 ? inlet_share(length, std::exp(node[k])) : 1e-20;
      slope[k] = std::log(1.0 / share - 1.0);
    }
    for (int order = 1; order < nodes; ++order)
      for (int k = nodes - 1; k >= order; --k)
        slope[k] = (slope[k] - slope[k - 1]) / (node[k] - node[k - order]);
  }

  // Returns the fraction for the film thickness h_c, the semi-axis b and the rolling radius R_x,
  // all in m.
  template <class T> RACEWAY_INLINE T share(const T &h_c, const T &b, const T &rolling_radius) const
  {
    const T H = 2.0 * rolling_radius * h_c / (b * b);
    const T x = logarithm(T(where(H > 1e-12, H, 1e-12)));
    const T at = where(x > high, high, where(x > low, x, low));
    T y = T() + slope[nodes - 1];
    for (int k = nodes - 2; k >= 0; --k) y = y * (at - node[k]) + slope[k];
    const T found = 1.0 / (1.0 + exponential(y));
    return where(found > 0.5, found, 0.5);
  }
};

}    // namespace raceway
