// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the laws of Hertz contacts, and the effective radii of a ball in its groove.
#include "../laws/hertz.h"
#include "exports.h"

using namespace raceway;

EXPORTS

RECORD(HertzEllipse, double kappa, first, second, radius;)
RECORD(SemiAxes, double a, b;)
RECORD(RadiiOfContact, double r_x, r_y;)
RECORD(CompleteElliptic, double K, E, D;)

// `form` is 0 for the exact solution, 1 for the fit of Hamrock and Brewe, and 2 for this fit as
// printed in the paper.
FORMULA(HertzEllipse, hertz_ellipse, (double r_x, double r_y, int form))
{
  const ContactEllipse c = contact_ellipse(r_x, r_y, Ellipse(form));
  return {c.kappa, c.Fbar, c.Ebar, hertz_radius(r_x, r_y)};
}

FORMULA(double, hertz_stiffness,
        (double kappa, double first, double second, double radius, double modulus))
{
  return hertz_stiffness({kappa, second, first}, radius, modulus);
}

FORMULA(SemiAxes, hertz_semi_axes,
        (double kappa, double second, double radius, double modulus, double load))
{
  const double a = hertz_semi_axis({kappa, second, 0.0}, radius, modulus, load);
  return {a, a / kappa};
}

// Returns the maximum pressure. It is computed from the semi-axes at 1 N, so that it is 0 if there
// is no load.
FORMULA(double, hertz_pressure,
        (double kappa, double second, double radius, double modulus, double load))
{
  const double a = hertz_semi_axis({kappa, second, 0.0}, radius, modulus, 1.0);
  return hertz_pressure(1.0, a, a / kappa) * std::cbrt(load);
}

FORMULA(double, hertz_load, (double stiffness, double overlap))
{
  return hertz_load(stiffness, overlap);
}

FORMULA(double, sphere_stiffness, (double radius_1, double radius_2, double modulus))
{
  return sphere_stiffness(radius_1, radius_2, modulus);
}

FORMULA(double, reduced_modulus,
        (double young_1, double poisson_1, double young_2, double poisson_2))
{
  return reduced_modulus(young_1, poisson_1, young_2, poisson_2);
}

FORMULA(double, tangential_ratio,
        (double young_1, double poisson_1, double young_2, double poisson_2))
{
  return tangential_ratio(young_1, poisson_1, young_2, poisson_2);
}

FORMULA(RadiiOfContact, effective_radii,
        (double ball, double groove, double pitch, bool inner, double cos_angle))
{
  const EffectiveRadii r = groove_radii(ball, groove, pitch, inner, cos_angle);
  return {r.x, r.y};
}

FORMULA(CompleteElliptic, complete_elliptic, (double m1))
{
  const EllipticIntegrals v = complete_elliptic(m1);
  return {v.K, v.E, v.D};
}
