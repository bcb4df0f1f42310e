// SPDX-License-Identifier: GPL-2.0-or-later
// Solves the Hertz contact with a film between the bodies that adds to the overlap (docs/tribology,
// Film in the gap).
//
//   x = d + z h(Q),  Q = K x^1.5,  h = e (Q/Q_0)^-m,  h = e below Q_0
//   x elastic approach of the bodies, m;  d overlap of the rigid surfaces, m (< 0 for a gap)
//   e film thickness at the load Q_0, m;  z fraction of the film thickness that adds to the overlap
//
// With r = x/x_0, x_0 = (Q_0/K)^(2/3) and n = 1.5 m, this is r - H r^-n = D for r > 1 and r - H = D
// below. The left side is an increasing, concave function of r, so there is exactly one root, which
// lies between 1 and D + H. A step from r to r (1 + e) uses four terms of the inverted Taylor
// series in Newton's relative step s. All derivatives follow from r^-n. The first step starts from
// D + H with an approximate r^-n and ends within 1e-3 of the root if the film is no thicker than 16
// x_0. One more step with the exact r^-n then reaches rounding accuracy. Thicker films need more
// steps. Each lane stops independently, so its result does not depend on the other lanes.
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

constexpr double power_law_cut = 1.0;      // load (N) below which the film thickness of a power law
                                           // is constant
constexpr double film_gap_reach = 0.01;    // thickness, as a fraction of the ball's radius, above
                                           // which a film is cut off. No film in a bearing is so
                                           // thick; cutting it off would make the force jump

template <class T> struct FilmGapT {
  T compression;    // x, m
  T thinning;       // h/e
  T slope;          // dx/dd
  T ln_load;        // ln(Q/Q_0), 0 below Q_0
};

namespace detail {
// One step from r towards the solution of r = D + H q, q = r^-n. It consists of Newton's step s and
// the four-term step e, both divided by r.
template <class T> struct GapStepT {
  T s, e;
};
template <class T>
RACEWAY_INLINE GapStepT<T> gap_step(const T &r, const T &h, const T &D, const T &n)
{
  const T inverse = 1.0 / (r + n * h), s = (D + h - r) * inverse, w = n * h * inverse;
  const T a = -0.5 * (n + 1.0) * w, b = (-1.0 / 3) * (n + 2.0) * a, c = -0.25 * (n + 3.0) * b,
          a2 = a * a;    // of e^2 and e^3, over the slope, e^4 divided by the slope
  const T fourth = a * (5.0 * a2 - 5.0 * b) + c;
  return {s, s * (1.0 - s * (a - s * ((2.0 * a2 - b) - s * fourth)))};
}
}    // namespace detail

// Solves the power law. The arguments are `zero`, which is x_0 in m; `film`, which is z e in m; and
// `load_exponent`, the exponent m. Precondition: overlap + film > 0.
template <class T>
RACEWAY_INLINE FilmGapT<T> compress(const T &overlap, const T &film, const T &zero,
                                    const T &load_exponent)
{
  constexpr int most = 30;
  constexpr double small = 1e-3;       // step whose fifth power is below rounding
  constexpr double long_step = 0.1;    // limit on the step, beyond which the series may diverge
  const T n = 1.5 * load_exponent, per = 1.0 / zero, D = overlap * per, H = film * per, all = D + H;
  const auto thinned = all > 1.0;
  const T from = where(thinned, all, 1.0);
  const T rough = H * rough_exponential(T(-n * rough_logarithm(from))), least = D + rough;
  const T near = from * (1.0 + detail::gap_step(from, rough, D, n).e);
  T r = where(near > least, near, least);
  r = where(r > 1.0, r, 1.0);
  T thinning = T() + 1.0, ln_r = T();
  auto busy = thinned;
  for (int k = 0; k < most && any(busy); ++k) {
    const T y = logarithm(r), q = exponential(T(-n * y));
    const auto go = detail::gap_step(r, T(H * q), D, n);
    const auto far = magnitude(go.s) > long_step;
    const T e = where(far, go.s, go.e);
    const T power =
        1.0 - n * e *
                  (1.0 - (n + 1.0) * 0.5 * e *
                             (1.0 - (n + 2.0) * (1.0 / 3) * e * (1.0 - (n + 3.0) * 0.25 * e)));
    thinning = where(busy, T(q * power), thinning);
    ln_r = where(busy, T(y + e * (1.0 - e * (0.5 - e * (1.0 / 3 - e * 0.25)))), ln_r);
    const T next = r * (1.0 + e);
    r = where(busy, T(where(next > 1.0, next, 1.0)), r);
    busy = busy & (magnitude(go.s) > small);
  }
  const T x = where(thinned, r, all);
  const T slope = x / (x + where(thinned, T(n * H * thinning), 0.0));
  return {zero * x, thinning, slope, 1.5 * ln_r};
}

// Returns the work (J) required to thin a film that follows a power law, starting from its
// thickness `edge` (m) at the load `cut` (N).
template <class T>
RACEWAY_INLINE T thinning_work(double share, const T &load_exponent, const T &load, const T &h,
                               double cut, const T &edge)
{
  return share * load_exponent / (1.0 - load_exponent) *
         where(load > cut, T(h * load - edge * cut), 0.0);
}

// Solves ln(x + gap) = ln(z h + squeezed) for any film law by Newton iteration from `start`; both
// sides are nearly linear in ln x. Law::at(ln x) gives the film thickness and the rate at which it
// decreases with ln x.
template <class T> struct FilmRootT {
  T compression, thickness, slope;    // m, m, dx/dd
};
template <class T, class Law>
RACEWAY_INLINE FilmRootT<T> squeeze(const Law &law, const T &overlap, double share, const T &start)
{
  constexpr int most = 100;
  constexpr double longest = 20.0;
  const T gap = where(overlap < 0.0, T(-overlap), 0.0),
          squeezed = where(overlap > 0.0, overlap, 0.0);
  T ln_x = start, x = T(), h = T(), fall = T();
  auto busy = start == start;
  for (int k = 0; k < most && any(busy); ++k) {
    const T here = exponential(ln_x), left = here + gap;
    const auto film = law.at(ln_x);
    const T film_here = share * film.thickness, right = film_here + squeezed;
    const T slope = here / left + 1.5 * film.fall * film_here / right;
    const T newton = -logarithm(T(left / right)) / slope;
    const T step = where(newton > longest, longest, where(newton < -longest, -longest, newton));
    ln_x = where(busy, T(ln_x + step), ln_x);
    x = where(busy, T(here * (1.0 + step)), x);
    h = where(busy, T(film.thickness * (1.0 - 1.5 * film.fall * step)), h);
    fall = where(busy, film.fall, fall);
    busy = busy & (magnitude(step) > 3e-8);
  }
  return {x, h, x / (x + 1.5 * share * fall * h)};
}

}    // namespace raceway
