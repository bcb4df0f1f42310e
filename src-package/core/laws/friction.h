// SPDX-License-Identifier: GPL-2.0-or-later
// Friction laws: the friction coefficient (docs/theory, Friction; Farah 2020 fig. 5), a tangential
// spring capped by Coulomb's law, and Coulomb's law smoothed over a creep speed.
//
// The friction coefficient mu is a constant or depends on the lambda ratio Lambda. In the latter
// case it is equal to its boundary-lubrication value below Lambda_1 and to its full-film value
// above Lambda_2. In between, it follows the cubic 3s^2 - 2s^3, s = (Lambda - Lambda_1)/(Lambda_2 -
// Lambda_1), so that mu and dmu/dLambda are continuous (the curve in fig. 5 is schematic; the cubic
// is our choice).
#pragma once

#include "../numbers/lane.h"

namespace raceway {

struct StribeckCurve {
  double mu_boundary = 0.0, mu_full = 0.0;
  double lambda_1 = 1.0, lambda_2 = 3.0;
};

template <class T> RACEWAY_INLINE T stribeck(const StribeckCurve &c, const T &lambda)
{
  const T s = (lambda - c.lambda_1) / (c.lambda_2 - c.lambda_1);
  const T mixed = c.mu_boundary + (c.mu_full - c.mu_boundary) * s * s * (3.0 - 2.0 * s);
  return where(lambda <= c.lambda_1, c.mu_boundary, where(lambda >= c.lambda_2, c.mu_full, mixed));
}

// Returns the lubrication regime: 0 boundary, 1 mixed, 2 full film.
inline int regime(const StribeckCurve &c, double lambda)
{
  return lambda < c.lambda_1 ? 0 : lambda > c.lambda_2 ? 2 : 1;
}

// Tangential spring-dashpot in the two directions t and w of the contact frame, capped at mu N. xi
// is the elongation of the spring (m); if the contact slides, xi is reset so that the sum of the
// spring and dashpot forces equals the cap. The contact frame turns with the ball's azimuth, so xi
// needs no transformation. The force of the raceway on the ball along -t and -w is returned in ft
// and fw.
template <class T> struct TangentialSpringT {
  T k = T();    // N/m
  T c = T();    // N s/m
};
using TangentialSpring = TangentialSpringT<double>;

template <class T>
RACEWAY_INLINE void tangential_force(const TangentialSpringT<T> &s, const T &cap, const T &vt,
                                     const T &vw, T *xi, T &ft, T &fw)
{
  ft = s.k * xi[0] + s.c * vt;
  fw = s.k * xi[1] + s.c * vw;
  const T f2 = ft * ft + fw * fw;
  const auto slides = f2 > cap * cap;
  if (!any(slides)) return;
  const T scale = cap / square_root(f2);
  ft = where(slides, T(ft * scale), ft);
  fw = where(slides, T(fw * scale), fw);
  xi[0] = where(slides, T((ft - s.c * vt) / s.k), xi[0]);
  xi[1] = where(slides, T((fw - s.c * vw) / s.k), xi[1]);
}

// Coulomb's law smoothed over a sliding speed v_0: f = mu N s/sqrt(|s|^2 + v_0^2). The law has no
// history. It is odd and monotonic in s, tends to mu N for |s| >> v_0 and acts as a dashpot mu
// N/v_0 at small s, so a loaded contact creeps slightly where a spring would stick. In a rolling
// contact the law acts as a traction curve: if v_0 = c u, where u is the entrainment speed, f
// depends only on the slide-roll ratio s/u, with a knee at s/u = c. Returns f/s in N s/m; `cap` is
// mu N.
template <class T, class S>
RACEWAY_INLINE T smoothed_friction(const T &cap, const S &slip_t, const S &slip_w, const S &v_0)
{
  return cap / square_root(S(slip_t * slip_t + slip_w * slip_w + v_0 * v_0));
}

}    // namespace raceway
