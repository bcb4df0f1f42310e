// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the film thickness by power laws (film.h) and in all lubrication regimes
// (film_regimes.h), factors on the film thickness (film_factors.h), and film damping
// (film_branch.h).
#include "../laws/film_branch.h"
#include "../laws/film_factors.h"
#include "../laws/film_regimes.h"
#include "exports.h"

#include <algorithm>

using namespace raceway;

RECORD(FilmThickness, double h_min, h_c;)
RECORD(FilmExponents, double speed, load;)
RECORD(GuptaParts, double unpressed, lost;)
RECORD(MaxwellBranch, double stiffness, rate;)
RECORD(BranchStep, double left, slope;)

// Returns the film thickness divided by R_x as a function of U, G and W. `model` is 0 for Masjedi
// and Khonsari, 1 for Masjedi and Khonsari as printed, and 2 for Hamrock and Dowson.
FORMULA(FilmThickness, film_thickness,
        (int model, double speed, double material, double load, double kappa))
{
  // these values are usually constant along an array, and computing them takes longer than all
  // other operations
  thread_local double known[3] = {-1.0, 0.0, 0.0};
  thread_local FilmPair laws;
  const double asked[3] = {double(model), material, kappa};
  if (!std::equal(asked, asked + 3, known)) {
    std::copy(asked, asked + 3, known);
    laws = film_laws(FilmModel(model), kappa, {1.0, material}, 1.0, 1.0);
  }
  const FilmPointT<double> at = film_point(speed, load);
  return {film_thickness(laws.min, at), film_thickness(laws.central, at)};
}

// Returns the exponents of the central film thickness.
FORMULA(FilmExponents, film_exponents, (int model, double kappa))
{
  const FilmLaw law = film_laws(FilmModel(model), kappa, {1.0, 1.0}, 1.0, 1.0).central;
  return {law.p, law.m};
}

FORMULA(double, composite_roughness, (double one, double other))
{
  return composite_roughness(one, other);
}

// Returns the film thickness divided by sqrt(U_s) R_x as a function of Moes's M and L and of lambda
// = R_x/R_y.
FORMULA(double, film_all_regimes, (double load, double material, double ratio))
{
  MoesRaceway raceway;
  raceway.ln_material = logarithm(material);
  const MoesShapeT<double> shape = moes_shape(1.0, -logarithm(ratio));
  return MoesFilmT<double>(raceway, shape, 0.0, 0.0).at(logarithm(load)).thickness;
}

FORMULA(double, thermal_loading,
        (double temperature_viscosity, double viscosity, double speed, double conductivity))
{
  return thermal_loading(temperature_viscosity, viscosity, speed, conductivity);
}

// Returns the film factor as a function of the thermal loading. `law` is 1 for Murch and Wilson and
// 2 for Wilson.
FORMULA(double, inlet_shear, (int law, double loading))
{
  FilmFactors f;
  f.inlet_shear = InletShear(law);
  f.ln_loading = logarithm(loading);
  return f.of(0.0);
}

// Returns Gupta's factor without the effect of pressure, and the reduction due to pressure before
// it is limited.
FORMULA(GuptaParts, gupta_parts, (double loading, double pressure, double slide_roll))
{
  FilmFactors f;
  f.ln_loading = logarithm(loading);
  const GuptaFactorT<double> g = f.gupta(0.0, slide_roll * slide_roll);
  return {g.unpressed, g.per_pressure * pressure};
}

FORMULA(MaxwellBranch, film_branch,
        (double k, double h_c, double compression, double b, double speed))
{
  const FilmBranchT<double> f = film_branch(k, h_c, compression, b, speed);
  return {f.stiffness, f.rate};
}

FORMULA(BranchStep, film_branch_step, (double stiffness, double rate, double dt, bool stage))
{
  const BranchStepT<double> step = branch_step(FilmBranchT<double>{stiffness, rate}, dt, stage);
  return {step.left, step.slope};
}
