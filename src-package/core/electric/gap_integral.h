// SPDX-License-Identifier: GPL-2.0-or-later
// The integral of dA/gap over the area outside the contact ellipse, m. Multiplied by the
// permittivity, it gives the capacitance of this area (docs/fix_bearing_capacitance, Description).
//
// For a loaded contact with the film thickness h within the ellipse and the Hertz gap g outside it:
//   I = 4 kappa Ebar R {G + pi P sqrt(2 R_x g_s)/b},  g_s = overlap/Fbar,  H = h/g_s,
// where G accounts for the area beside the ellipse, which is treated as strips along rolling, each
// of them a line contact, and depends only on H. P accounts for the area beyond the ends of the
// ellipse, along the groove's cross-section up to S. Both are fits to integrals, accurate to 1 % of
// the capacitance of plates and surroundings together for conformities from 0.505 to 0.54, h from
// 20 nm to 2 um, and loads up to 3 kN on a 6208.
//
// If there is no load and the gap is g_0, the integral is the limit of the above form for zero load
// and h = g_0, so that both forms agree:
//   I = 4 pi sqrt(R_x R_y') asinh(S/sqrt(2 R_y' g_0)),  R_y' = Fbar a^2/(2 e overlap c),
// e = ln(4 kappa) - 1. At c = 1, R_y' equals the radius R_y across the groove to within 1 %. c is 1
// - play/(r_c - R_b): if there is clearance, the centres of the ball and of the groove's
// cross-section are closer together, and the gap is flatter. Beyond the position of concentric
// circles c < 0, and asinh becomes asin.
//
// 4 kappa Ebar R = 2 Fbar a b/overlap and sqrt(2 R_x g_s)/b do not depend on the load, and Fbar =
// pi E' a/(3 K sqrt(overlap)), so all quantities follow from the constants of the contact law
// (hertz.h).
#pragma once

#include "../raceway/raceway_law.h"

namespace raceway {

// The part of the integral that depends neither on the load nor on the film.
template <class T> struct GapShapeT {
  T a;        // sqrt(m), semi-axis across the groove divided by sqrt(overlap)
  T Fbar;     // overlap/g_s
  T scale;    // m, 4 kappa Ebar R
  T ends;     // pi sqrt(2 R_x g_s)/(b root_e)
  T log_4_kappa;
  T e, root_e;    // log_4_kappa - 1
  T least_D;      // lower limit of D in GapEnd
  T log_H;        // logarithm of H at a load of 1 N and h = 1 m
};
using GapShape = GapShapeT<double>;

// Eprime is defined in hertz.h (Pa), and R_x is the radius along rolling (m). An ellipse whose
// longer axis is along rolling, which does not occur in a groove, is treated as a circle.
template <class T>
RACEWAY_INLINE GapShapeT<T> gap_shape(const RacewayConstantsT<T> &k, double Eprime, const T &Rx)
{
  const double pi = 3.14159265358979323846;
  GapShapeT<T> s;
  const T kappa = k.a / k.b;
  s.a = k.a;
  s.Fbar = pi * Eprime * k.a / (3.0 * k.K);
  s.scale = 2.0 * s.Fbar * k.a * k.b;
  s.log_4_kappa = logarithm(T(4.0 * where(kappa > 1.0, kappa, 1.0)));
  s.e = s.log_4_kappa - 1.0;
  s.root_e = square_root(s.e);
  s.ends = pi * square_root(T(2.0 * Rx / s.Fbar)) / (k.b * s.root_e);
  s.least_D = 1.0 / (0.9 * s.root_e);
  s.log_H = logarithm(T(s.Fbar / k.unit));
  return s;
}

// G is up/down, a function of the sixth root X of H, accurate to 0.2 % of the integral.
template <class T> struct GapBeside {
  T up, down;

  RACEWAY_INLINE explicit GapBeside(const T &X)
  {
    const T under = 1.0 + X * (0.95409 + 0.86606 * X);
    up = 3.14159265358979323846 * under;
    down = X * X * (X * under + 0.88494 * (1.0 - 0.12025 * X));
  }
};

// P is ln(stretch)/sqrt(e). At the end of the ellipse the stretch is 1/v, with
// v = X^3 + sqrt(e) - 1/D, which is down/D.
template <class T> struct GapEnd {
  T D, down;

  RACEWAY_INLINE GapEnd(const GapShapeT<T> &s, const T &X, const T &X3)
  {
    const T fit = -1.254 + 0.4523 * s.log_4_kappa + X * (4.773 + X * (-3.520 + 3.690 * X));
    // D has a lower limit far outside the range of the fit
    D = where(fit > s.least_D, fit, s.least_D);
    down = (X3 + s.root_e) * D - 1.0;
  }
};

// The gap of a loaded contact, computed from the square root of the overlap (sqrt(m)), the
// logarithms of the load (N) and of h (m), and h itself.
template <class T> struct LoadedGapT {
  const GapShapeT<T> &shape;
  T root, H, end, G;

  RACEWAY_INLINE LoadedGapT(const GapShapeT<T> &s, const T &any_root, const T &ln_load, const T &h,
                            const T &ln_h) : shape(s)
  {
    const auto pressed = any_root > 1e-8;    // otherwise the limit for zero load is used, to
                                             // rounding accuracy
    root = where(pressed, any_root, 1e-8);
    T ln_X = (s.log_H + ln_h) * (1.0 / 6) - ln_load * (1.0 / 9);
    if (any(!pressed))
      ln_X = where(pressed, ln_X, T(logarithm(T(h * s.Fbar / (root * root))) * (1.0 / 6)));
    const T X = exponential(ln_X), X3 = X * X * X;
    H = X3 * X3;
    const GapBeside<T> beside(X);
    const GapEnd<T> tip(s, X, X3);
    const T inverse = 1.0 / (beside.down * tip.down);    // one division for both
    G = beside.up * (inverse * tip.down);
    end = tip.D * (inverse * beside.down);
  }
  // Returns the stretch up to the reach of the groove on one side (m).
  RACEWAY_INLINE T stretch(const T &reach) const
  {
    const GapShapeT<T> &s = shape;
    const T a = s.a * root, far = where(reach > a, reach, a);
    const T product = 1.0 / (far * a), eta = far * far * product;
    const T under = s.e * eta * eta + H - s.log_4_kappa + 2.0 / 3 * (a * a * product);
    return (s.root_e * eta + square_root(where(under > 0.0, under, 0.0))) * end;
  }
};

// Returns the stretch whose logarithm is the inverse sine of z; z is limited to 1.
RACEWAY_INLINE double sine_stretch(double z) { return std::exp(std::asin(z < 1.0 ? z : 1.0)); }
RACEWAY_INLINE Lane sine_stretch(const Lane &z)
{
  return Lane{sine_stretch(z[0]), sine_stretch(z[1]), sine_stretch(z[2]), sine_stretch(z[3])};
}

// The gap between surfaces that do not touch, for the gap width g (m) and c. G is 0.
template <class T> struct OpenGapT {
  T wider;    // 1/sqrt(c) or, for concentric circles, its limit to rounding accuracy

  RACEWAY_INLINE OpenGapT(const GapShapeT<T> &s, const T &g, const T &any_c) : c(any_c)
  {
    const T size = magnitude(c), kept = where(size > 1e-9, size, 1e-9), root = square_root(kept);
    const T wide = s.a * square_root(T(s.Fbar * g)), inverse = 1.0 / (root * wide);
    over = s.root_e * (kept * inverse);
    wider = wide * inverse;
  }
  RACEWAY_INLINE T stretch(const T &reach) const
  {
    const T z = over * where(reach > 0.0, reach, 0.0);
    const T open = z + square_root(T(z * z + 1.0));
    const auto past = c < 0.0;
    return any(past) ? T(where(past, sine_stretch(z), open)) : open;
  }

 private:
  T c, over;
};

// Returns the integral I, m, from the gap and the stretches on both sides.
template <class T>
RACEWAY_INLINE T gap_integral(const GapShapeT<T> &s, const T &G, const T &near, const T &far)
{
  const T both = where(near > 1.0, near, 1.0) * where(far > 1.0, far, 1.0);
  return s.scale * (G + s.ends * (0.5 * logarithm(both)));
}

}    // namespace raceway
