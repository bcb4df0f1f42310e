// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the capacitance of a contact ellipse (capacitance.h) and of the gap around it
// (gap_integral.h).
#include "../electric/capacitance.h"
#include "../electric/gap_integral.h"
#include "exports.h"

using namespace raceway;

FORMULA(double, vacuum_permittivity, ()) { return raceway::vacuum_permittivity; }
FORMULA(double, density_ratio, (double pressure)) { return density_ratio(pressure); }

FORMULA(double, permittivity, (double ambient, double pressure))
{
  return permittivity_at(ambient, pressure);
}

FORMULA(double, mean_permittivity, (double ambient, double pressure))
{
  return mean_permittivity(ambient, pressure);
}

FORMULA(double, contact_capacitance, (double permittivity, double a, double b, double h))
{
  return contact_capacitance(permittivity, a, b, h);
}

FORMULA(double, series_capacitance, (double inner, double outer))
{
  return series_capacitance(inner, outer);
}

FORMULA(double, rough_film_factor, (double sigma_over_h))
{
  return rough_film_factor(sigma_over_h);
}

namespace {
// Returns the shape of the gap around an ellipse. No contact law is needed, because E' cancels out.
GapShape shape_of(double kappa, double first, double second, double radius, double r_x, double E,
                  double &K)
{
  const ContactEllipse c = {kappa, second, first};
  RacewayConstants k;
  k.K = K = hertz_stiffness(c, radius, E);
  k.a = hertz_semi_axis(c, radius, E, K);
  k.b = k.a / kappa;
  k.unit = std::pow(K, -2.0 / 3.0);
  return gap_shape(k, E, r_x);
}
}    // namespace

// Returns G for the gap beside the ellipse along the rolling direction. `ratio` is H = h/g_s.
FORMULA(double, gap_beside, (double ratio))
{
  const GapBeside<double> beside(std::pow(ratio, 1.0 / 6.0));
  return beside.up / beside.down;
}

// Returns P for the gap beyond one end of the ellipse, up to `reach`, which is in units of a.
FORMULA(double, gap_beyond, (double ratio, double kappa, double reach))
{
  GapShape s = {};
  s.a = 1.0;
  s.log_4_kappa = std::log(4.0 * kappa);
  s.e = s.log_4_kappa - 1.0;
  s.root_e = std::sqrt(s.e);
  s.least_D = 1.0 / (0.9 * s.root_e);
  const LoadedGapT<double> loaded(s, 1.0, 0.0, ratio, std::log(ratio));
  const double stretch = reach > 0.0 ? loaded.stretch(reach) : 1.0;
  return stretch > 1.0 ? std::log(stretch) / s.root_e : 0.0;
}

// Returns I (m) for the gap around a loaded contact. `near` and `far` are the half-widths of the
// groove (m).
FORMULA(double, gap_loaded,
        (double kappa, double first, double second, double radius, double modulus, double r_x,
         double load, double separation, double near, double far))
{
  double K;
  const GapShape s = shape_of(kappa, first, second, radius, r_x, modulus, K);
  const LoadedGapT<double> loaded(s, std::cbrt(load / K), std::log(load), separation,
                                  std::log(separation));
  return gap_integral(s, loaded.G, loaded.stretch(near), loaded.stretch(far));
}

// Returns I (m) for an unloaded ball. `flatness` is 1 - play/(r_c - R_b).
FORMULA(double, gap_open,
        (double kappa, double first, double second, double radius, double r_x, double separation,
         double flatness, double near, double far))
{
  double K;
  const GapShape s = shape_of(kappa, first, second, radius, r_x, 1.0, K);
  const OpenGapT<double> open(s, separation, flatness);
  return open.wider * gap_integral(s, 0.0, open.stretch(near), open.stretch(far));
}
