// SPDX-License-Identifier: GPL-2.0-or-later
// A film between the bodies: it adds to the overlap that Hertz's law sees (docs/tribology, Film in
// the gap).
//
//   x = d + z h(Q),  Q = K x^1.5,  h = e (Q/Q_0)^-m,  h = e below Q_0
//   x what the bodies give way, d the overlap of the rigid surfaces, negative for a gap, m
//   e the film at the load Q_0, m;  z its share
//
// With r = x/x_0, x_0 = (Q_0/K)^(2/3), n = 1.5 m this is r - H r^-n = D for r > 1, r - H = D below:
// the left side grows with r, so there is one root. It is concave: Newton's method from below never
// passes the root. D + H is above it, D + H (D + H)^-n below. It starts at Chebyshev's step of
// third order from the one, which is no worse than the other. What follows a relative change below
// 3e-8 is below rounding: one step for a loaded ball, a few near the edge of the film. Each lane
// stops by itself, so its bits do not depend on the others.
#ifndef RACEWAY_FILM_GAP_H
#define RACEWAY_FILM_GAP_H

#include "exp_log.h"

namespace raceway {

template <class T> struct FilmGapT {
  T compression;    // x, m
  T thinning;       // h/e
  T slope;          // dx/dd
};

// zero: x_0; film: z e, m; load_exponent: m. Pre-condition: overlap + film > 0.
template <class T>
RACEWAY_INLINE FilmGapT<T> compress(const T &overlap, const T &film, const T &zero,
                                    const T &load_exponent)
{
  constexpr int most = 12;
  const T n = 1.5 * load_exponent, D = overlap / zero, H = film / zero, all = D + H;
  const auto thinned = all > 1.0;
  const T above = where(thinned, all, 1.0), film_above = H * exponential(T(-n * logarithm(above)));
  const T slope_above = 1.0 + n * film_above / above, off = (H - film_above) / slope_above;
  const T bend = 0.5 * n * (n + 1.0) * film_above / (above * above * slope_above);
  const T below = D + film_above, first = all - off * (1.0 - off * bend);
  T r = where(first > below, first, below), thinning = T() + 1.0;
  r = where(r > 1.0, r, 1.0);
  auto busy = thinned;
  for (int k = 0; k < most && any(busy); ++k) {
    const T q = exponential(T(-n * logarithm(r))), h = H * q;
    const T step = (D + h - r) / (r + n * h);    // over r
    thinning = where(busy, T(q * (1.0 - n * step)), thinning);
    r = where(busy, T(r + r * step), r);
    busy = busy & (magnitude(step) > 3e-8);
  }
  const T x = where(thinned, r, all);
  const T slope = x / (x + where(thinned, T(n * H * thinning), 0.0));
  return {zero * x, thinning, slope};
}

// Any law of the film, thickness and fall over ln x: ln(x + gap) = ln(z h + squeezed), which is
// nearly straight in ln x on both sides, by Newton's method from `start`. Law::at(ln x) gives both.
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

#endif
