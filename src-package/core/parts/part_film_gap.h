// SPDX-License-Identifier: GPL-2.0-or-later
// Elastic contact with the film in the gap (film_gap.h), which replaces the plain Hertz contact.
// The load sets in at a gap that is as wide as the film of a lightly loaded contact. The derivative
// with respect to the overlap is exact at constant entrainment speed.
//
// The film follows either the power law of film.h, with a constant thickness below 1 N, or the law
// for all regimes (gap_film.h).
#pragma once

#include "../raceway/gap_film.h"
#include "part_hertz.h"

namespace raceway {

struct FilmInGapPart : PartBase {
  static constexpr const char *name = "film_in_gap", *slot = "elastic";
  static constexpr bool needs_film = true;
  static constexpr double cut = power_law_cut;
  struct Parameters {
    double share = 1.0;
    bool all_regimes = false;
    double unit_of_cut = std::pow(cut, 2.0 / 3.0);    // compression at the load `cut` relative to
                                                      // that at 1 N
    MoesRaceway moes;                                 // computed by prepare()
    void prepare(const Raceway &p)
    {
      if (all_regimes)
        moes = {p.model.lubricant, p.material.Eprime(), p.rolling_radius(1.0),
                p.transverse_radius()};
    }
    double reach(const Raceway &p) const { return film_gap_reach * p.groove.ball_radius; }
    double widest(const Raceway &p) const { return share > 0.0 ? p.reach / share : p.reach; }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"gap",
             "",
             true,
             {P::within(
                 "ZETA", "fraction of the film that adds to the overlap", 0.0, 2.0,
                 [](Raceway &, Parameters &own) -> double & { return own.share; },
                 "no film in the gap")},
             nullptr,
             "contacts begin at a gap"},
            {"gap_film",
             "",
             true,
             {P::one_of("film in the gap", "power|moes",
                        [](Raceway &, Parameters &own, int k) { own.all_regimes = k == 1; })},
             nullptr,
             "film of *gap*: the power law of *film*, constant below 1 N, or the law of all "
             "regimes by Nijenbanning, Venner and Moes"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"compression", "m", "elastic approach of the bodies", vanishes},
             &ContactState::compression,
             Needs::film,
             false}};
  }

  // Returns true if there is no load at this position and speed. NaN does not count as a gap.
  template <class T>
  static RACEWAY_INLINE auto misses(const Parameters &own, const Raceway &p,
                                    const RacewayConstantsT<T> &k, ContactStateT<T> &c)
  {
    c.ln_speed = logarithm(c.entrainment);
    if (p.factors.any && !p.factors.by_pressure) c.film_factor = p.factors.of(c.ln_speed);
    if (own.all_regimes) {    // a film of unlimited thickness, counted only up to the reach
      c.h_edge = where(c.entrainment > resting, T() + own.widest(p), 0.0);
    } else if (p.factors.by_pressure) {
      const T film = GapFilmT<T, false>(own.moes, p, k, c).at(logarithm(kept(own, k))).thickness;
      c.h_edge = where(own.share * film < p.reach, film, own.widest(p));
      c.h_edge = where(c.entrainment > resting, c.h_edge, 0.0);
    } else {
      T film = exponential(
          T(k.film.central.lnA + k.film.central.p * c.ln_speed + k.film.central.m * std::log(cut)));
      if (p.factors.any) film = film * c.film_factor;
      c.h_edge = where(own.share * film < p.reach, film, p.reach / own.share);
    }
    return beyond(own, c) <= 0.0;
  }
  // Returns the overlap beyond the onset of the load, m. It must be called after misses().
  template <class T>
  static RACEWAY_INLINE T beyond(const Parameters &own, const ContactStateT<T> &c)
  {
    return c.overlap + own.share * c.h_edge;
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &m,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B d = held(c.overlap);
    if (own.all_regimes || p.factors.by_pressure) {
      const FilmRootT<B> g =
          own.all_regimes ? root<true>(own, p, k, d, c) : root<false>(own, p, k, d, c);
      c.compression = g.slope * (c.overlap - d) + g.compression;
      HertzContactPart::act({}, p, k, m, c);
      c.stiffness = c.stiffness * g.slope;
      c.h_c = g.thickness;
      const B Q = held(c.load);
      c.film_load = where(Q > cut, Q, cut);
      c.ln_film_load = logarithm(c.film_load);
      return;
    }
    const B film = own.share * c.h_edge, exponent = -k.film.central.m;
    const FilmGapT<B> g = compress(d, film, kept(own, k), exponent);
    c.compression = g.slope * (c.overlap - d) + g.compression;
    HertzContactPart::act({}, p, k, m, c);
    c.stiffness = c.stiffness * g.slope;
    c.h_c = c.h_edge * g.thinning;
    const B Q = held(c.load);
    c.film_load = where(Q > cut, Q, cut);
    c.ln_film_load = std::log(cut) + g.ln_load;
    c.film_energy = thinning_work(own.share, exponent, Q, c.h_c, cut, c.h_edge);
  }

  // Returns the work done against the film since the onset of thinning, at constant entrainment
  // speed.
  template <class T>
  static RACEWAY_INLINE Value<T> energy(const Parameters &own, const Raceway &p,
                                        const ContactStateT<T> &c)
  {
    const Value<T> elastic = HertzContactPart::energy({}, p, c);
    if (own.all_regimes) return elastic + work<true>(own, p, c);
    if (p.factors.by_pressure) return elastic + work<false>(own, p, c);
    return elastic + c.film_energy;
  }

 private:
  // Returns the compression below which the film thickness of a power law is constant, m.
  template <class T>
  static RACEWAY_INLINE T kept(const Parameters &own, const RacewayConstantsT<T> &k)
  {
    return k.unit * own.unit_of_cut;
  }

  // Finds the root for films without a closed-form solution; above c.h_edge the film thickness is
  // h_edge.
  template <bool all, class T>
  static RACEWAY_INLINE FilmRootT<Value<T>> root(const Parameters &own, const Raceway &p,
                                                 const RacewayConstantsT<Value<T>> &k,
                                                 const Value<T> &d, const ContactStateT<T> &c)
  {
    using B = Value<T>;
    const GapFilmT<B, all> film(own.moes, p, k, c);
    const FilmRootT<B> g = squeeze(film, d, own.share, film.start(d, kept(own, k)));
    const auto wide = g.thickness >= c.h_edge;
    return {where(wide, B(d + own.share * c.h_edge), g.compression),
            where(wide, c.h_edge, g.thickness), where(wide, 1.0, g.slope)};
  }

  // Returns the energy required to squeeze the film, i.e. the integral of zeta m h over the load,
  // where m is the decrease of ln h with ln Q.
  template <bool all, class T>
  static RACEWAY_INLINE Value<T> work(const Parameters &own, const Raceway &p,
                                      const ContactStateT<T> &c)
  {
    using B = Value<T>;
    const RacewayConstantsT<B> k = p.law.at(c.cos_angle);
    const GapFilmT<B, all> film(own.moes, p, k, c);
    const auto moves = c.h_edge > 0.0;
    const B edge = where(moves, c.h_edge, own.widest(p));
    const B work = own.share * film.work(B(held(c.compression)), edge, kept(own, k));
    return where(moves, work, 0.0);
  }
};

}    // namespace raceway
