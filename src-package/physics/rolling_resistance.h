// SPDX-License-Identifier: GPL-2.0-or-later
// Couples that resist rolling (docs/theory, Rolling resistance).
//
// Hydrodynamic: the inlet of the film pushes back with f and takes the power 2 f u (Biboulet and
// Houpert 2010, part 2, eq 32; here in powers of u and Q, Balan et al. 2015, within 0.6 % of it):
//   f/(E' R_x^2) = (I - E)/(1 + M/6.6) + E,  r = R_y/R_x,  U = eta u/(E' R_x),  W = Q/(E' R_x^2),
//   I = 2.9766 r^0.3316 W^(1/3) U^(2/3),  E = 7.5826 r^0.4055 W^(1/3) U^(3/4),
//   M = 0.5549 r^-0.6029 W U^(-3/4).
// Inlet shear warms the oil: 3.94/(3.94 + L^0.62), L = beta eta u^2/k_f (Murch and Wilson 1975).
//
// Hysteresis of the steel: couple alpha Q 2b/(3 pi) (Johnson 1985, section 9.4).
#ifndef RACEWAY_ROLLING_RESISTANCE_H
#define RACEWAY_ROLLING_RESISTANCE_H

#include "exp_log.h"

namespace raceway {

// Logarithms of what does not change in a run.
struct RollingConstants {
  double speed = 0.0, modulus = 0.0, transverse = 0.0;    // of eta/E', E' and R_y

  RollingConstants() = default;
  RollingConstants(double viscosity, double E, double transverse_radius) :
      speed(std::log(viscosity / E)), modulus(std::log(E)), transverse(std::log(transverse_radius))
  {
  }
};

// f, N. ln_u, ln_q and ln_x are the logarithms of u (m/s), Q (N) and R_x (m).
template <class T>
RACEWAY_INLINE T rolling_force(const RollingConstants &k, const T &ln_u, const T &ln_q,
                               const T &ln_x)
{
  const T u = k.speed + ln_u - ln_x, unit = k.modulus + 2.0 * ln_x, w = ln_q - unit;
  const T r = k.transverse - ln_x;
  const T rigid = 2.9766 * exponential(T(0.3316 * r + w * (1.0 / 3.0) + u * (2.0 / 3.0)));
  const T elastic = rigid * (7.5826 / 2.9766) * exponential(T(0.0739 * r + u * (1.0 / 12.0)));
  const T mean = 0.5549 * exponential(T(-0.6029 * r + w - 0.75 * u));
  return exponential(unit) * ((rigid - elastic) / (1.0 + mean / 6.6) + elastic);
}

// 1 without heating: ln_heating = ln(beta eta/k_f) is minus infinity then.
template <class T> RACEWAY_INLINE T inlet_shear(double ln_heating, const T &ln_u)
{
  return 3.94 / (3.94 + exponential(T(0.62 * (ln_heating + 2.0 * ln_u))));
}

// N m
template <class T> RACEWAY_INLINE T hysteresis_couple(double alpha, const T &load, const T &b)
{
  return alpha * load * b * (2.0 / (3.0 * 3.14159265358979323846));
}

}    // namespace raceway

#endif
