// SPDX-License-Identifier: GPL-2.0-or-later
// Factors on the smooth, isothermal, fully flooded film (docs/tribology, Factors of the film).
//
// Inlet shear heats the oil that enters: with the thermal loading L = beta eta u^2/k_f
//   Murch and Wilson 1975   3.94/(3.94 + L^0.62)
//   Wilson 1979             1/(1 + 0.1 L^0.64)
// Starvation is a number of the user's. The derivative of a law holds the factor.
#ifndef RACEWAY_FILM_FACTORS_H
#define RACEWAY_FILM_FACTORS_H

#include "exp_log.h"

namespace raceway {

enum class InletShear { none, murch, wilson };

struct FilmFactors {
  InletShear inlet_shear = InletShear::none;
  double temperature_viscosity = 0.0;    // beta, 1/K, -d(ln eta)/dT
  double conductivity = 0.0;             // k_f, W/(m K)
  double starvation = 1.0;

  // derived by prepare()
  double ln_loading = 0.0;    // ln(L/u^2)
  bool any = false;

  void prepare(double viscosity)
  {
    any = inlet_shear != InletShear::none || starvation != 1.0;
    if (inlet_shear != InletShear::none)
      ln_loading = std::log(temperature_viscosity * viscosity / conductivity);
  }

  // Of the logarithm of the entrainment speed (m/s).
  template <class T> RACEWAY_INLINE T of(const T &ln_speed) const
  {
    const T all = T() + starvation;
    if (inlet_shear == InletShear::none) return all;
    const T ln_L = ln_loading + 2.0 * ln_speed;
    if (inlet_shear == InletShear::murch)
      return all * (3.94 / (3.94 + exponential(T(0.62 * ln_L))));
    return all / (1.0 + 0.1 * exponential(T(0.64 * ln_L)));
  }
};

}    // namespace raceway

#endif
