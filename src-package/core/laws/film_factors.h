// SPDX-License-Identifier: GPL-2.0-or-later
// Factors that correct the thickness of a smooth, isothermal, fully flooded film (docs/tribology,
// Film thickness factors).
//
// Shear in the inlet heats the oil that enters. With the thermal loading L = beta eta u^2/k_f, the
// factor is
//   Murch and Wilson 1975   3.94/(3.94 + L^0.62)
//   Wilson 1979             1/(1 + 0.1 L^0.64)
//   Gupta et al. 1992       (1 - 13.2 P L^0.42)/(1 + 0.213 (1 + 2.23 S^0.83) L^0.64)
// where P = p_max/E', S = s/u, and s is the sliding speed. They are valid for L below about 10. The
// term 13.2 P L^0.42 is limited to 0.9. Starvation is a factor given by the user. The factors are
// treated as constants in the derivatives of a law.
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

enum class InletShear { none, murch, wilson, gupta };

// Returns the thermal loading L from the entrainment speed (m/s), which is half the sum of the
// surface speeds.
inline double thermal_loading(double temperature_viscosity, double viscosity, double speed,
                              double conductivity)
{
  return temperature_viscosity * viscosity * speed * speed / conductivity;
}

// Returns the factor of Murch and Wilson from ln L.
template <class T> RACEWAY_INLINE T murch_wilson(const T &ln_L)
{
  return 3.94 / (3.94 + exponential(T(0.62 * ln_L)));
}

// Gupta's factor for a contact is unpressed (1 - least(per_pressure P, 0.9)).
template <class T> struct GuptaFactorT {
  T unpressed, per_pressure;

  RACEWAY_INLINE T loss(const T &pressure) const
  {
    const T x = per_pressure * pressure;
    return where(x < most, x, most);
  }
  RACEWAY_INLINE T of(const T &pressure) const { return unpressed * (1.0 - loss(pressure)); }
  static constexpr double most = 0.9;
};

struct FilmFactors {
  InletShear inlet_shear = InletShear::none;
  double temperature_viscosity = 0.0;    // beta, 1/K, -d(ln eta)/dT
  double conductivity = 0.0;             // k_f, W/(m K)
  double starvation = 1.0;

  // computed by prepare()
  double ln_loading = 0.0;    // ln(L/u^2)
  bool any = false;
  bool by_pressure = false;    // true: Gupta's factor is used, and of() does not include it

  void prepare(double viscosity)
  {
    any = inlet_shear != InletShear::none || starvation != 1.0;
    by_pressure = inlet_shear == InletShear::gupta;
    if (inlet_shear != InletShear::none)
      ln_loading = std::log(thermal_loading(temperature_viscosity, viscosity, 1.0, conductivity));
  }

  // Returns the product of all factors except Gupta's, from the logarithm of the entrainment speed
  // (m/s).
  template <class T> RACEWAY_INLINE T of(const T &ln_speed) const
  {
    const T all = T() + starvation;
    if (inlet_shear == InletShear::none) return all;
    const T ln_L = ln_loading + 2.0 * ln_speed;
    if (inlet_shear == InletShear::murch) return all * murch_wilson(ln_L);
    return all / (1.0 + 0.1 * exponential(T(0.64 * ln_L)));
  }
  // Returns Gupta's factor, which is 1 at rest; slip2 is the squared sliding speed, m^2/s^2.
  template <class T> RACEWAY_INLINE GuptaFactorT<T> gupta(const T &ln_speed, const T &slip2) const
  {
    const auto moves = ln_speed > -50.0;
    const T ln_u = where(moves, ln_speed, -50.0), ln_L = ln_loading + 2.0 * ln_u;
    const T slid = 1.0 + 2.23 * exponential(T(0.83 * (0.5 * logarithm(slip2) - ln_u)));
    const T unpressed = starvation / (1.0 + 0.213 * slid * exponential(T(0.64 * ln_L)));
    return {where(moves, unpressed, starvation),
            where(moves, T(13.2 * exponential(T(0.42 * ln_L))), 0.0)};
  }
};

}    // namespace raceway
