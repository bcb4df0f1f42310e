// SPDX-License-Identifier: GPL-2.0-or-later
// Integral of dA/gap over what lies outside the contact ellipse, in m: times the permittivity it is
// the capacitance there (docs/fix_bearing_capacitance, Surroundings).
//
// Loaded, with h between the surfaces of the ellipse and g the Hertz gap outside:
//   I = 4 kappa Ebar R {G + pi P sqrt(2 R_x g_s)/b},  g_s = overlap/Fbar,  H = h/g_s,
// G beside the ellipse (strips along rolling, each a line contact; universal in H), P beyond its
// ends along the groove's section, to S. Both are fits to integrals, good to 1 % of plates and
// surroundings together for conformity 0.505 to 0.54, h 20 nm to 2 um, loads to 3 kN on a 6208.
//
// Without load, at the gap g_0, it is what that tends to as the load goes to 0 with h = g_0, so
// that both meet:
//   I = 4 pi sqrt(R_x R_y') asinh(S/sqrt(2 R_y' g_0)),  R_y' = Fbar a^2/(2 e overlap c),
// e = ln(4 kappa) - 1. At c = 1 R_y' is the radius across the groove R_y within 1 %. c is
// 1 - play/(r_c - R_b): with play the centres of ball and groove come closer, and the gap is
// flatter. Past concentric circles c < 0 and the inverse sine takes over.
//
// 4 kappa Ebar R = 2 Fbar a b/overlap and sqrt(2 R_x g_s)/b do not depend on the load, and Fbar =
// pi E' a/(3 K sqrt(overlap)): all follows from the constants of the contact law (hertz.h).
#ifndef RACEWAY_GAP_INTEGRAL_H
#define RACEWAY_GAP_INTEGRAL_H

#include "raceway_law.h"

namespace raceway {

// What of it does not depend on load or film.
template <class T> struct GapShapeT {
  T a;        // sqrt(m), semi-axis across over sqrt(overlap)
  T Fbar;     // overlap/g_s
  T scale;    // m, 4 kappa Ebar R
  T ends;     // pi sqrt(2 R_x g_s)/b
  T log_4_kappa;
  T e, root_e;    // log_4_kappa - 1
};
using GapShape = GapShapeT<double>;

// Eprime as in hertz.h (Pa), R_x along rolling (m). An ellipse that is longer along rolling, which
// no groove has, counts as a circle.
template <class T>
RACEWAY_INLINE GapShapeT<T> gap_shape(const RacewayConstantsT<T> &k, double Eprime, const T &Rx)
{
  const double pi = 3.14159265358979323846;
  GapShapeT<T> s;
  const T kappa = k.a / k.b;
  s.a = k.a;
  s.Fbar = pi * Eprime * k.a / (3.0 * k.K);
  s.scale = 2.0 * s.Fbar * k.a * k.b;
  s.ends = pi * square_root(T(2.0 * Rx / s.Fbar)) / k.b;
  s.log_4_kappa = logarithm(T(4.0 * where(kappa > 1.0, kappa, 1.0)));
  s.e = s.log_4_kappa - 1.0;
  s.root_e = square_root(s.e);
  return s;
}

// G at the sixth root X of H; within 0.2 % of the integral.
template <class T> RACEWAY_INLINE T gap_beside_ellipse(const T &X)
{
  const T more = 0.88494 * (1.0 - 0.12025 * X) / (1.0 + X * (0.95409 + 0.86606 * X));
  return 3.14159265358979323846 / (X * X * (X + more));
}

// P is ln(stretch)/sqrt(e); v is the stretch that the end of the ellipse takes.
template <class T> RACEWAY_INLINE T gap_end(const GapShapeT<T> &s, const T &X)
{
  const T D = -1.254 + 0.4523 * s.log_4_kappa + X * (4.773 + X * (-3.520 + 3.690 * X));
  // far outside the range of the fit the end stays an end
  const T part = where(D * s.root_e > 1.0 / 0.9, T(1.0 / D), T(0.9 * s.root_e));
  return X * X * X + s.root_e - part;
}

// Of a loaded contact: root of its overlap (sqrt(m)), h (m).
template <class T> struct LoadedGapT {
  const GapShapeT<T> &shape;
  T root, H, v, G;

  RACEWAY_INLINE LoadedGapT(const GapShapeT<T> &s, const T &any_root, const T &h) : shape(s)
  {
    root = where(any_root > 1e-8, any_root, 1e-8);    // the limit without load, to rounding
    H = h * s.Fbar / (root * root);
    const T X = exponential(T(logarithm(H) * (1.0 / 6)));
    v = gap_end(s, X);
    G = gap_beside_ellipse(X);
  }
  // to the groove's reach on one side (m)
  RACEWAY_INLINE T stretch(const T &reach) const
  {
    const GapShapeT<T> &s = shape;
    const T far = reach / (s.a * root), eta = where(far > 1.0, far, 1.0);
    const T under = s.e * eta * eta + H - s.log_4_kappa + 2.0 / (3.0 * eta);
    return (s.root_e * eta + square_root(where(under > 0.0, under, 0.0))) / v;
  }
};

// The stretch whose logarithm is the inverse sine of z, at most 1.
RACEWAY_INLINE double sine_stretch(double z) { return std::exp(std::asin(z < 1.0 ? z : 1.0)); }
RACEWAY_INLINE Lane sine_stretch(const Lane &z)
{
  return Lane{sine_stretch(z[0]), sine_stretch(z[1]), sine_stretch(z[2]), sine_stretch(z[3])};
}

// Of surfaces that do not touch, at the gap g (m), with c of them; G is 0 there.
template <class T> struct OpenGapT {
  T root;    // of c; the limit for concentric circles, to rounding

  RACEWAY_INLINE OpenGapT(const GapShapeT<T> &s, const T &g, const T &any_c) : c(any_c)
  {
    const T size = magnitude(c);
    root = square_root(T(where(size > 1e-9, size, 1e-9)));
    over = s.root_e * root / (s.a * square_root(T(s.Fbar * g)));
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

// I, m
template <class T>
RACEWAY_INLINE T gap_integral(const GapShapeT<T> &s, const T &G, const T &stretch)
{
  const T P = logarithm(stretch) / s.root_e;
  return s.scale * (G + s.ends * where(P > 0.0, P, 0.0));
}

}    // namespace raceway

#endif
