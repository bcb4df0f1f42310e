// SPDX-License-Identifier: GPL-2.0-or-later
// Exports oil data as functions of temperature (oil_data.h), SKF's starvation factor (starvation.h)
// and pure rolling (rolling.h).
#include "../laws/oil_data.h"
#include "../laws/rolling.h"
#include "../laws/starvation.h"
#include "exports.h"

using namespace raceway;

RECORD(NuAndSlope, double value, slope;)
RECORD(OilState, double viscosity, pressure_viscosity, temperature_viscosity, density,
       permittivity;)
RECORD(RollingSpeeds, double orbit, spin;)

// Returns nu in mm^2/s and -d(ln nu)/dT in 1/K.
FORMULA(NuAndSlope, walther, (double nu_40, double nu_100, double temperature))
{
  const KinematicViscosity nu = walther(nu_40, nu_100, temperature);
  return {nu.value, nu.slope};
}

FORMULA(NuAndSlope, vogel,
        (double k, double b, double c, double density_40, double density_slope, double temperature))
{
  const KinematicViscosity nu =
      vogel(k, b, c, OilData{density_40, density_slope, 0.0, 0.0, 0.0}, temperature);
  return {nu.value, nu.slope};
}

FORMULA(OilState, oil_at_temperature,
        (double density_40, double density_slope, double pressure_viscosity_40,
         double pressure_viscosity_100, double permittivity_40, double nu, double nu_slope,
         double temperature))
{
  const OilAtTemperature oil = at_temperature(
      {density_40, density_slope, pressure_viscosity_40, pressure_viscosity_100, permittivity_40},
      {nu, nu_slope}, temperature);
  return {oil.viscosity, oil.pressure_viscosity, oil.temperature_viscosity, oil.density,
          oil.permittivity};
}

FORMULA(double, skf_starvation,
        (double bore, double outside, double kinematic, double speed, double replenishment,
         double slender))
{
  return skf_starvation(bore, outside, kinematic, speed, replenishment, slender);
}

FORMULA(RollingSpeeds, pure_rolling,
        (double ball, double pitch, double inner_speed, double outer_speed))
{
  const Rolling found = pure_rolling(ball, pitch, inner_speed, outer_speed);
  return {found.orbit, found.spin};
}
