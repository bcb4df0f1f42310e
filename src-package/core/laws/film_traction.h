// SPDX-License-Identifier: GPL-2.0-or-later
// Friction coefficient of a sliding film in a Hertz contact (docs/tribology, Traction):
//   tau(p) = min(tau_0 asinh(eta(p) s/(h tau_0)), Lambda_L p),  eta(p) after Roelands,
//   mu Q = integral of tau over the ellipse = 3 Q/p_max integral of tau(t p_max) t dt, t in 0 to 1,
// The integral is evaluated at eight Gauss points in t = sqrt(1 - r^2), where the radius r is in
// units of the semi-axes. The error is at most 0.9 % (2.8 % with six points) and is mostly due to
// the kink of tau. The sliding speed s is assumed to be uniform over the ellipse.
#pragma once

#include "../numbers/exp_log.h"
#include "film.h"

namespace raceway {

template <class T> RACEWAY_INLINE T inverse_sinh(const T &x)
{
  const T x2 = x * x, small = x * (1.0 - x2 * (1.0 / 6.0 - x2 * (3.0 / 40.0)));
  return where(x < 1e-3, small, logarithm(T(x + square_root(T(x2 + 1.0)))));
}

// Returns the shear stress tau, Pa, from x = eta s/(h tau_0).
template <class T> RACEWAY_INLINE T eyring_shear(double stress, const T &x, const T &most)
{
  const T tau = stress * inverse_sinh(x);
  return where(tau > most, most, tau);
}

// Roelands' equation: ln(eta(p)/eta(0)) = lift ((1 + p/unit)^exponent - 1)
struct Roelands {
  static constexpr double unit = 1.96e8;    // Pa
  double lift = 0.0, exponent = 0.0;

  Roelands() = default;
  explicit Roelands(const Lubricant &oil) :
      lift(std::log(oil.viscosity) + 9.67), exponent(unit * oil.pressure_viscosity / lift)
  {
  }
  template <class T> RACEWAY_INLINE T ln_rise(const T &pressure) const
  {
    const T raised = logarithm(T(1.0 + pressure / unit)) * exponent;
    return lift * (exponential(raised) - 1.0);
  }
};

struct FilmTraction {
  double stress = 0.0, limit = 0.0;    // tau_0, Pa; Lambda_L

  // computed from the values above
  Roelands roelands;
  double ln_rate = 0.0;    // ln(eta_0/tau_0)

  bool asked() const { return stress > 0.0; }
  void prepare(const Lubricant &oil)
  {
    if (!asked()) return;
    roelands = Roelands(oil);
    ln_rate = std::log(oil.viscosity / stress);
  }

  // Returns the friction coefficient from the maximum pressure (Pa) and the logarithm of the shear
  // rate s/h (1/s). The Gauss points are evaluated in lanes, in a function that is compiled once
  // rather than inlined into every law.
  __attribute__((noinline)) double coefficient(double pressure, double ln_shear) const
  {
    // Gauss-Legendre nodes on 0 to 1
    constexpr Lane node[2] = {
        {0.019855071751231912, 0.10166676129318664, 0.2372337950418355, 0.40828267875217511},
        {0.59171732124782483, 0.7627662049581645, 0.89833323870681336, 0.98014492824876809}};
    constexpr Lane weight[2] = {
        {0.050614268145188532, 0.11119051722668721, 0.15685332293894344, 0.18134189168918083},
        {0.18134189168918083, 0.15685332293894344, 0.11119051722668721, 0.050614268145188532}};
    double total = 0.0;
    for (int k = 0; k < 2; ++k) {
      const Lane p = node[k] * pressure;
      const Lane ln_x = ln_rate + roelands.ln_rise(p) + ln_shear;
      const Lane x = exponential(Lane(where(ln_x < most, ln_x, most)));
      total += sum(Lane(weight[k] * node[k] * eyring_shear(stress, x, Lane(limit * p))));
    }
    return 3.0 * total / pressure;
  }
  RACEWAY_INLINE Lane coefficient(const Lane &pressure, const Lane &ln_shear) const
  {
    Lane mu;
    for (int i = 0; i < lanes; ++i) mu[i] = coefficient(pressure[i], ln_shear[i]);
    return mu;
  }

 private:
  static constexpr double most = 300.0;    // upper limit of ln x, where tau is far above Lambda_L p
};

}    // namespace raceway
