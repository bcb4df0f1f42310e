// SPDX-License-Identifier: GPL-2.0-or-later
// Elliptical Hertz contact of two smooth elastic bodies (docs/theory, Elliptical Hertz contact;
// Farah 2020 eq. 2).
//
//   Q = K overlap^1.5,  K = pi kappa E' sqrt(Ebar R / (4.5 Fbar^3)),  1/R = 1/R_x + 1/R_y,
//   E' = 2/sum((1 - nu^2)/E),
//   a = (6 kappa^2 Ebar Q R / (pi E'))^(1/3),  b = a/kappa,  p_max = 1.5 Q/(pi a b).
//
// R_x is the effective radius along the rolling direction and R_y across the groove. Internally,
// the longer axis of the ellipse is called "major". The reported kappa = a/b is the axis across the
// groove divided by the axis along rolling, so it may be below 1. All values are in SI units.
// Source of the exact relation: Johnson, Contact Mechanics (1985), eqs 4.25-4.28; fits: Hamrock &
// Brewe 1983, and the form printed in Farah 2020 (F = 1 + q ln alpha).
#pragma once

#include "elliptic.h"

#include <cmath>

namespace raceway {

enum class Ellipse { exact, hamrock, printed };

struct ContactEllipse {
  double kappa = 1.0;    // a/b: axis across the groove divided by axis along rolling
  double Ebar = 0.0;     // elliptic integral of the second kind
  double Fbar = 0.0;     // elliptic integral of the first kind
};

// Finds the axis ratio from the ratio of effective radii by bisection and the secant method in
// ln(kappa), from R_minor/R_major = (1/R_y)/(1/R_x) = m1 D(m)/(K(m) - D(m)), m1 = 1/kappa^2.
inline ContactEllipse exact_ellipse_major(double alpha)    // alpha = R_y/R_x >= 1
{
  // f is monotonic in L = ln kappa, f(0) = -ln(alpha) <= 0, and kappa <= alpha always holds.
  auto residual = [alpha](double L, EllipticIntegrals &v) {
    const double m1 = std::exp(-2.0 * L);
    v = complete_elliptic(m1);
    return std::log((v.K - v.D) / (m1 * v.D)) - std::log(alpha);
  };
  EllipticIntegrals v;
  double lo = 0.0, hi = std::log(alpha) + 1e-12;
  double L = 2.0 / 3.14159265358979323846 * std::log(alpha);
  double previous = residual(lo, v), at = lo;
  for (int it = 0; it < 100; ++it) {
    const double f = residual(L, v);
    if (f > 0.0) hi = L;
    else lo = L;
    // secant slope, safeguarded by the bracket
    double next = L - f * (L - at) / (f - previous);
    if (!(next > lo && next < hi)) next = 0.5 * (lo + hi);
    at = L;
    previous = f;
    if (std::fabs(next - L) <= 1e-16 * (1.0 + L)) break;
    L = next;
  }
  ContactEllipse c;
  c.kappa = std::exp(L);
  c.Ebar = v.E;
  c.Fbar = v.K;
  return c;
}

inline ContactEllipse fitted_ellipse_major(double alpha, Ellipse form)
{
  const double pi = 3.14159265358979323846, q = 0.5 * pi - 1.0;
  ContactEllipse c;
  c.kappa = std::pow(alpha, 2.0 / pi);
  c.Ebar = 1.0 + q / alpha;
  c.Fbar = (form == Ellipse::printed ? 1.0 : 0.5 * pi) + q * std::log(alpha);
  return c;
}

// Returns the ellipse for any R_y/R_x. F and E are functions of the squared modulus 1 - 1/kappa^2.
// If R_y/R_x is below 1, the axes are swapped: with kappa' = 1/kappa, F(1 - 1/kappa^2) = kappa' F(1
// - 1/kappa'^2) and E(1 - 1/kappa^2) = E(1 - 1/kappa'^2)/kappa'.
inline ContactEllipse contact_ellipse(double Rx, double Ry, Ellipse form)
{
  const bool swapped = Ry < Rx;
  const double alpha = swapped ? Rx / Ry : Ry / Rx;
  ContactEllipse c =
      form == Ellipse::exact ? exact_ellipse_major(alpha) : fitted_ellipse_major(alpha, form);
  if (!swapped) return c;
  return {1.0 / c.kappa, c.Ebar * c.kappa, c.Fbar / c.kappa};
}

inline double hertz_radius(double Rx, double Ry) { return 1.0 / (1.0 / Rx + 1.0 / Ry); }

// Returns the stiffness K of the contact, N/m^1.5.
inline double hertz_stiffness(const ContactEllipse &c, double R, double Eprime)
{
  const double pi = 3.14159265358979323846;
  return pi * c.kappa * Eprime * std::sqrt(c.Ebar * R / (4.5 * c.Fbar * c.Fbar * c.Fbar));
}

// Returns the semi-axis a (m) at a load (N); b is a/kappa.
inline double hertz_semi_axis(const ContactEllipse &c, double R, double Eprime, double load)
{
  const double pi = 3.14159265358979323846;
  return std::cbrt(6.0 * c.kappa * c.kappa * c.Ebar * load * R / (pi * Eprime));
}

// Returns the maximum pressure (Pa) of an ellipse with these semi-axes (m).
inline double hertz_pressure(double load, double a, double b)
{
  const double pi = 3.14159265358979323846;
  return 1.5 * load / (pi * a * b);
}

// Returns the load Q (N) at an overlap (m).
inline double hertz_load(double stiffness, double overlap)
{
  return overlap <= 0.0 ? 0.0 : stiffness * overlap * std::sqrt(overlap);
}

struct HertzContact {
  ContactEllipse ellipse;
  double R = 0.0;    // m, 1/R = 1/R_x + 1/R_y
  double K = 0.0;    // N/m^1.5
  double a = 0.0;    // sqrt(m): semi-axis across the groove = a sqrt(overlap)
  double b = 0.0;    // sqrt(m): semi-axis along rolling     = b sqrt(overlap)
  double p = 0.0;    // Pa/sqrt(m): p_max = p sqrt(overlap)
};

// Range of Young's moduli accepted by styles and data files, Pa.
constexpr double LEAST_YOUNG = 1e8, LARGEST_YOUNG = 1e13;

// Returns E' = 2/sum((1 - nu^2)/E), Pa.
inline double reduced_modulus(double E1, double nu1, double E2, double nu2)
{
  return 2.0 / ((1.0 - nu1 * nu1) / E1 + (1.0 - nu2 * nu2) / E2);
}

inline HertzContact hertz_contact(double Rx, double Ry, double Eprime, Ellipse form)
{
  HertzContact h;
  h.ellipse = contact_ellipse(Rx, Ry, form);
  h.R = hertz_radius(Rx, Ry);
  h.K = hertz_stiffness(h.ellipse, h.R, Eprime);
  h.a = hertz_semi_axis(h.ellipse, h.R, Eprime, h.K);
  h.b = h.a / h.ellipse.kappa;
  h.p = hertz_pressure(h.K, h.a, h.b);
  return h;
}

// Effective radii of a ball in a groove, computed from the cosine of the contact angle alpha
// (docs/theory, Geometry): gamma = R_b cos(alpha)/r_pitch, R_x = R_b (1 -+ gamma), R_y = R_b
// r_c/(r_c - R_b).
struct EffectiveRadii {
  double x, y;
};
inline EffectiveRadii groove_radii(double ball_radius, double groove_radius, double pitch_radius,
                                   bool inner, double cos_angle)
{
  const double gamma = ball_radius * cos_angle / pitch_radius;
  return {ball_radius * (inner ? 1.0 - gamma : 1.0 + gamma),
          ball_radius * groove_radius / (groove_radius - ball_radius)};
}

// Returns the stiffness of two spheres, K = 4/3 E* sqrt(R), E* = E'/2 (this is Farah 2020 eq. 3
// without its extra factor 1/(1 - nu); multiply by 1/(1 - nu) to obtain the printed form).
inline double sphere_stiffness(double R1, double R2, double Eprime)
{
  return 2.0 / 3.0 * Eprime * std::sqrt(R1 * R2 / (R1 + R2));
}

// Returns the ratio of tangential to normal incremental stiffness of a sticking circular contact,
// k_t/k_n = 4 G*/E*, 1/G* = sum((2 - nu)/G), E* = E'/2 (Mindlin 1949; 2(1-nu)/(2-nu) for bodies of
// the same material).
inline double tangential_ratio(double E1, double nu1, double E2, double nu2)
{
  const double g =
      1.0 / ((2.0 - nu1) * 2.0 * (1.0 + nu1) / E1 + (2.0 - nu2) * 2.0 * (1.0 + nu2) / E2);
  return 4.0 * g / (0.5 * reduced_modulus(E1, nu1, E2, nu2));
}

// Returns the smallest overlap (m) at which the semi-axis across the groove, a sqrt(overlap),
// reaches the groove radius, where the half-space assumption of Hertz is no longer valid. `raceway
// static` uses the same limit.
inline double widest_overlap(double a, double groove_radius)
{
  const double ratio = groove_radius / a;
  return ratio * ratio;
}

}    // namespace raceway
