// SPDX-License-Identifier: GPL-2.0-or-later
// Computes oil properties at a given temperature from data sheet values (docs/tribology,
// Temperature dependence of lubricant properties). Temperatures are in degrees C, kinematic
// viscosities in mm^2/s.
//   Walther, ASTM D341   lg lg(nu + 0.7) = A - B lg T, T in K, through nu at 40 and 100 C
//   Vogel                eta = k exp(b/(T + c))
//   density, 1/xi        linear in temperature (at ambient pressure, FVA 3 gives 1/xi this form)
//   permittivity         Clausius-Mossotti: (e - 1)/(e + 2) proportional to the density
#pragma once

#include <cmath>

namespace raceway {

struct KinematicViscosity {
  double value;    // nu, mm^2/s
  double slope;    // -d(ln nu)/dT, 1/K
};

// Precondition: nu_40 > nu_100 > 0.3, below which the double logarithm is not defined.
inline KinematicViscosity walther(double nu_40, double nu_100, double temperature)
{
  const auto twice = [](double nu) { return std::log10(std::log10(nu + 0.7)); };
  const double kelvin = temperature + 273.15, ln10 = std::log(10.0);
  const double b = (twice(nu_40) - twice(nu_100)) / std::log10(373.15 / 313.15);
  const double inner = std::pow(10.0, twice(nu_40) - b * std::log10(kelvin / 313.15));
  const double lifted = std::pow(10.0, inner), nu = lifted - 0.7;
  return {nu, b * ln10 * inner * lifted / (nu * kelvin)};
}

struct OilData {
  double density_40;                                       // kg/m^3
  double density_slope;                                    // kg/(m^3 K), decrease in density per
                                                           // kelvin of temperature rise
  double pressure_viscosity_40, pressure_viscosity_100;    // 1/Pa
  double permittivity_40;                                  // relative

  double density(double temperature) const
  {
    return density_40 - density_slope * (temperature - 40.0);
  }
};

// k is in Pa s, b in K, c in degrees C
inline KinematicViscosity vogel(double k, double b, double c, const OilData &oil,
                                double temperature)
{
  const double rho = oil.density(temperature), lift = b / (temperature + c);
  return {1.0e6 * k * std::exp(lift) / rho, lift / (temperature + c) - oil.density_slope / rho};
}

struct OilAtTemperature {
  double viscosity;                // eta, Pa s
  double pressure_viscosity;       // xi, 1/Pa
  double temperature_viscosity;    // -d(ln eta)/dT, 1/K
  double density;                  // kg/m^3
  double permittivity;             // relative
};

inline OilAtTemperature at_temperature(const OilData &oil, const KinematicViscosity &nu,
                                       double temperature)
{
  const double rho = oil.density(temperature), share = (temperature - 40.0) / 60.0;
  const double e = oil.permittivity_40;
  const double x = (e - 1.0) / (e + 2.0) * rho / oil.density_40;
  return {1.0e-6 * nu.value * rho,
          1.0 / ((1.0 - share) / oil.pressure_viscosity_40 + share / oil.pressure_viscosity_100),
          nu.slope + oil.density_slope / rho, rho, (1.0 + 2.0 * x) / (1.0 - x)};
}

}    // namespace raceway
