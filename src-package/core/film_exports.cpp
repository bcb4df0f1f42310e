// SPDX-License-Identifier: GPL-2.0-or-later
// Film thickness: power laws (film.h), all regimes (film_regimes.h), factors (film_factors.h).
#include "../physics/film.h"
#include "exports.h"

using namespace raceway;

RECORD(FilmThickness, double h_min, h_c;)
RECORD(FilmExponents, double speed, load;)

// of R_x, by U, G, W; model: 0 Masjedi and Khonsari, 1 that as printed, 2 Hamrock and Dowson
FORMULA(FilmThickness, film_thickness,
        (int model, double speed, double material, double load, double kappa))
{
  const FilmPair laws = film_laws(FilmModel(model), kappa, {1.0, material}, 1.0, 1.0);
  const FilmPointT<double> at = film_point(speed, load);
  return {film_thickness(laws.min, at), film_thickness(laws.central, at)};
}

// of the central thickness
FORMULA(FilmExponents, film_exponents, (int model, double kappa))
{
  const FilmLaw law = film_laws(FilmModel(model), kappa, {1.0, 1.0}, 1.0, 1.0).central;
  return {law.p, law.m};
}

FORMULA(double, composite_roughness, (double one, double other))
{
  return composite_roughness(one, other);
}
