// SPDX-License-Identifier: GPL-2.0-or-later
// Film thickness of one contact at one entrainment speed, as a function of the compression x of the
// bodies. It is used for film laws that have no closed-form solution, i.e. the law for all regimes
// (film_regimes.h) or one with a factor that depends on the pressure (Gupta, film_factors.h).
#pragma once

#include "../laws/film_gap.h"
#include "../laws/film_regimes.h"
#include "contact_state.h"
#include "raceway.h"

namespace raceway {

constexpr double resting = 1e-9;    // m/s, entrainment speed below which a contact is dry

// The power law, as a function of the logarithm of the load.
template <class T> struct PowerFilmT {
  T ln_h, fall;    // logarithm of the thickness at 1 N; -d(ln h)/d(ln Q)
  RACEWAY_INLINE FilmAtLoadT<T> at(const T &ln_load) const
  {
    return {exponential(T(ln_h - fall * ln_load)), fall};
  }
};

// all: true for the law that covers all lubrication regimes, false for a power law.
template <class T, bool all> class GapFilmT {
 public:
  using Film = std::conditional_t<all, MoesFilmT<T>, PowerFilmT<T>>;

  // steep: Gupta's factor as a function of the root of the compression, excluding `unpressed`,
  // which is included in the film, or null. K is the stiffness, N/m^1.5
  RACEWAY_INLINE GapFilmT(const Film &film, const GuptaFactorT<T> *steep, const T &K) :
      film_(film), pressed_(steep != nullptr), ln_K_(logarithm(K))
  {
    if (steep) steep_ = *steep;
  }
  template <class State>
  RACEWAY_INLINE GapFilmT(const MoesRaceway &moes, const Raceway &p, const RacewayConstantsT<T> &k,
                          const State &c)
  {
    // at rest any finite speed can be used, because the contact is treated as dry (FilmInGapPart)
    const T ln_u = logarithm(T(where(c.entrainment > resting, c.entrainment, resting)));
    T ln_factor = T();
    pressed_ = p.factors.by_pressure;
    if (pressed_) {
      const T along = held(c.sliding_t), across = held(c.sliding_w);
      const GuptaFactorT<T> g = p.factors.gupta(ln_u, T(along * along + across * across));
      ln_factor = logarithm(g.unpressed);
      steep_ = {T() + 1.0, g.per_pressure * k.p / p.material.Eprime()};
    } else if (p.factors.any) {
      ln_factor = logarithm(p.factors.of(ln_u));
    }
    ln_K_ = logarithm(k.K);
    if constexpr (all) {
      const T radius = p.rolling_radius(c.cos_angle);
      film_ = {moes, moes.shape(c.cos_angle, radius, p.rolling_radius(1.0)), ln_u, ln_factor};
    } else {
      film_ = {k.film.central.lnA + k.film.central.p * ln_u + ln_factor, -k.film.central.m};
    }
  }

  RACEWAY_INLINE FilmAtLoadT<T> at(const T &ln_x) const
  {
    FilmAtLoadT<T> f = film_.at(T(ln_K_ + 1.5 * ln_x));
    if (!pressed_) return f;
    const T root = exponential(T(0.5 * ln_x)), lost = steep_.loss(root);
    f.thickness = f.thickness * (1.0 - lost);
    f.fall = f.fall + where(lost < steep_.most, T(lost / (3.0 * (1.0 - lost))), 0.0);
    return f;
  }

  // Returns the logarithm of a lower bound on the compression at the overlap d. `kept` is the
  // compression below which the film thickness of a power law is constant.
  RACEWAY_INLINE T start(const T &d, const T &kept) const
  {
    const T squeezed = logarithm(T(where(d > 0.0, d, 1e-30)));
    const T least = all ? light(T(where(d < 0.0, T(-d), 1e-30))) : logarithm(kept);
    return where(squeezed > least, squeezed, least);
  }

  // Returns the work that thins the film from `edge` (m) to its thickness at the compression x,
  // divided by zeta, J. It is the integral of (fall h) over the load, evaluated at Gauss points in
  // the logarithm of the compression.
  RACEWAY_INLINE T work(const T &x, const T &edge, const T &kept) const
  {
    constexpr int panels = 24, points = 4;
    constexpr double node[points] = {-0.86113631159405258, -0.33998104358485626,
                                     0.33998104358485626, 0.86113631159405258};
    constexpr double weight[points] = {0.34785484513745386, 0.65214515486254614,
                                       0.65214515486254614, 0.34785484513745386};
    const T first = begins(edge, kept), last = logarithm(x);
    const T part = where(last > first, T((last - first) / panels), 0.0);
    T sum = T();
    for (int i = 0; i < panels; ++i)
      for (int k = 0; k < points; ++k) {
        const T ln_x = first + (i + 0.5 + 0.5 * node[k]) * part;
        const FilmAtLoadT<T> f = at(ln_x);
        sum = sum + weight[k] * f.fall * f.thickness * exponential(T(ln_K_ + 1.5 * ln_x));
      }
    return 0.75 * part * sum;
  }

 private:
  // Returns the logarithm of the compression of a rigid contact with the film h, or with the widest
  // film of an elastic contact.
  RACEWAY_INLINE T light(const T &h) const
  {
    if constexpr (all) {
      const T ln_h = logarithm(h), widest = film_.widest();
      return (film_.below(where(ln_h > widest, ln_h, widest)) - ln_K_) * (2.0 / 3.0);
    } else {
      return h;
    }
  }

  // Returns the logarithm of the compression at which the film thickness equals `edge`.
  RACEWAY_INLINE T begins(const T &edge, const T &kept) const
  {
    T ln_x = all ? light(edge) : logarithm(kept);
    const T ln_edge = logarithm(edge);
    for (int i = 0; i < 12; ++i) {
      const FilmAtLoadT<T> f = at(ln_x);
      const T step = (logarithm(f.thickness) - ln_edge) / (1.5 * f.fall);
      ln_x = ln_x + where(magnitude(step) > 1e-14, step, 0.0);
    }
    return ln_x;
  }

  Film film_;
  bool pressed_ = false;
  GuptaFactorT<T> steep_{};    // as a function of the root of the compression
  T ln_K_;
};

}    // namespace raceway
