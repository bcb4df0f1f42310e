// SPDX-License-Identifier: GPL-2.0-or-later
// Couples due to rolling resistance (docs/tribology, Rolling resistance).
//
// Hydrodynamic: the film inlet exerts a resisting force f and dissipates the power 2 f u (Biboulet
// and Houpert 2010, part 2, eq 32; here in powers of u and Q after Balan et al. 2015, accurate to
// 0.6 %):
//   f/(E' R_x^2) = (I - E)/(1 + M/6.6) + E,  r = R_y/R_x,  U = eta u/(E' R_x),  W = Q/(E' R_x^2),
//   I = 2.9766 r^0.3316 W^(1/3) U^(2/3),  E = 7.5826 r^0.4055 W^(1/3) U^(3/4),
//   M = 0.5549 r^-0.6029 W U^(-3/4).
// Inlet shear heats the oil, which reduces f by 1/(1 + 0.29 L^0.78), L being the thermal loading of
// film_factors.h (Aihara 1987).
//
// Hysteresis of the steel causes a couple alpha Q 2b/(3 pi) (Johnson 1985, section 9.4).
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

// Logarithms of the constants.
struct RollingConstants {
  double speed = 0.0, modulus = 0.0, transverse = 0.0;    // ln of eta/E', E' and R_y

  RollingConstants() = default;
  RollingConstants(double viscosity, double E, double transverse_radius) :
      speed(std::log(viscosity / E)), modulus(std::log(E)), transverse(std::log(transverse_radius))
  {
  }
};

// Geometry factors (SI units) of the law, written with v = u^(1/12) as
//   f = rigid Q^(1/3) v^8 ((1 - elastic v) v^9/(v^9 + mean Q) + elastic v).
template <class T> struct RollingShapeT {
  T rigid, elastic, mean;
};
template <class T>
RACEWAY_INLINE RollingShapeT<T> rolling_shape(const RollingConstants &k, const T &rolling_radius)
{
  const T ln_x = logarithm(rolling_radius), u = k.speed - ln_x, unit = k.modulus + 2.0 * ln_x;
  const T r = k.transverse - ln_x;
  return {2.9766 * exponential(T(0.3316 * r + unit * (2.0 / 3.0) + u * (2.0 / 3.0))),
          (7.5826 / 2.9766) * exponential(T(0.0739 * r + u * (1.0 / 12.0))),
          (0.5549 / 6.6) * exponential(T(-0.6029 * r - unit - 0.75 * u))};
}

// Returns the force f, N. ln_u is the logarithm of u (m/s), and `root` is the cube root of Q,
// N^(1/3).
template <class T>
RACEWAY_INLINE T rolling_force(const RollingShapeT<T> &k, const T &ln_u, const T &load,
                               const T &root)
{
  const T v = exponential(T(ln_u * (1.0 / 12.0))), v2 = v * v, v4 = v2 * v2, v8 = v4 * v4;
  const T v9 = v8 * v, elastic = k.elastic * v;
  return k.rigid * root * v8 * ((1.0 - elastic) * v9 / (v9 + k.mean * load) + elastic);
}

// Returns the inlet shear factor of the force f from ln L.
template <class T> RACEWAY_INLINE T rolling_inlet_shear(const T &ln_L)
{
  return 1.0 / (1.0 + 0.29 * exponential(T(0.78 * ln_L)));
}

// Returns the couple due to hysteresis, N m.
template <class T> RACEWAY_INLINE T hysteresis_couple(double alpha, const T &load, const T &b)
{
  return alpha * load * b * (2.0 / (3.0 * 3.14159265358979323846));
}

}    // namespace raceway
