// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic contact with its film in the gap (film_gap.h), in place of Hertz's alone: contacts
// begin at a gap as wide as the film of a lightly loaded contact. The slope over the overlap is
// exact; the derivative holds the entrainment speed.
#ifndef RACEWAY_PART_FILM_GAP_H
#define RACEWAY_PART_FILM_GAP_H

#include "film_gap.h"
#include "part_hertz.h"

namespace raceway {

struct FilmInGapPart : PartBase {
  static constexpr const char *name = "film_in_gap", *slot = "elastic";
  static constexpr bool needs_film = true;
  static constexpr double cut = 1.0;    // N, below it the film keeps its thickness
  struct Parameters {
    double share = 1.0;
    double unit_of_cut = std::pow(cut, 2.0 / 3.0);    // compression under it over that under 1 N
    // wider than films of bearings: none is cut off, or a force would jump
    double reach(const Raceway &p) const { return 0.01 * p.groove.ball_radius; }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"gap",
             "",
             true,
             {P::within(
                 "ZETA", "share of the film that adds to the overlap", 0.0, 2.0,
                 [](Raceway &, Parameters &own) -> double & { return own.share; },
                 "no film in the gap")},
             nullptr,
             "contacts begin at a gap; the film below 1 N is that at 1 N"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"compression", "m", "what the elastic bodies give way", vanishes},
             [](const Raceway &, const ContactState &s) { return s.compression; },
             Needs::film,
             false}};
  }

  // Whether there is no load at this position and speed. What is not a number is no gap.
  template <class T>
  static RACEWAY_INLINE auto misses(const Parameters &own, const Raceway &p,
                                    const RacewayConstantsT<T> &k, ContactStateT<T> &c)
  {
    const T ln_u = logarithm(c.entrainment);
    const T film = exponential(T(k.film.central.lnA + k.film.central.p * ln_u +
                                 k.film.central.m * std::log(cut))) *
                   p.factors.of(ln_u);
    c.h_edge = where(own.share * film < p.reach, film, p.reach / own.share);
    return c.overlap + own.share * c.h_edge <= 0.0;
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &m,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B d = held(c.overlap), film = own.share * c.h_edge, exponent = -k.film.central.m;
    const B zero = B(k.unit * own.unit_of_cut);
    const FilmGapT<B> g = compress(d, film, zero, exponent);
    c.compression = g.slope * (c.overlap - d) + g.compression;
    HertzContactPart::act({}, p, k, m, c);
    c.stiffness = c.stiffness * g.slope;
    c.h_c = c.h_edge * g.thinning;
    const B Q = held(c.load);
    c.film_load = where(Q > cut, Q, cut);
    c.film_energy = own.share * exponent / (1.0 - exponent) *
                    where(Q > cut, B(c.h_c * Q - c.h_edge * cut), 0.0);
  }

  // The work against the film begins where it begins to thin; at a constant entrainment speed.
  template <class T> static RACEWAY_INLINE Value<T> energy(const ContactStateT<T> &c)
  {
    return HertzContactPart::energy(c) + c.film_energy;
  }
};

}    // namespace raceway

#endif
