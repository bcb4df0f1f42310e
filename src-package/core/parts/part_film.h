// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the film thickness and the lambda ratio at the current load and entrainment speed
// (film.h); the thickness is multiplied by the factors in film_factors.h. In derivatives,
// thickness, ratio and factors are treated as constant, which affects the convergence of the Newton
// iteration but not its result.
#pragma once

#include "../laws/friction.h"
#include "part.h"

namespace raceway {

// Returns the central film thickness, for use in the act() of a later part. If the film is in the
// gap, it has already been computed.
template <class T>
RACEWAY_INLINE Value<T> held_central_film(const Raceway &p, const RacewayConstantsT<Value<T>> &k,
                                          const ContactStateT<T> &c)
{
  using B = Value<T>;
  if (p.reach > 0.0) return held(c.h_c);
  const FilmPointT<B> at = film_point(c.entrainment, c.film_load);
  const B h = film_thickness(k.film.central, at);
  return p.factors.any ? B(h * film_factor(p, k, c, at)) : h;
}

struct FilmThicknessPart : PartBase {
  static constexpr const char *name = "film_thickness";
  static constexpr When when = When::with_film;

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {
        {"lubricant",
         "",
         false,
         {P::positive(
              "ETA", "viscosity (Pa s)",
              [](Raceway &p, Parameters &) -> double & { return p.model.lubricant.viscosity; },
              "must be given"),
          P::positive(
              "XI", "pressure-viscosity coefficient (1/Pa)",
              [](Raceway &p, Parameters &) -> double & {
                return p.model.lubricant.pressure_viscosity;
              },
              "must be given")}},
        {"film",
         "",
         false,
         {P::one_of(
             "film", "masjedi|masjedi/printed|hamrock",
             [](Raceway &p, Parameters &, int k) { p.model.film = static_cast<FilmModel>(k); })},
         nullptr,
         "eqs (6) and (9) with corrected exponents, as printed, or Hamrock and Dowson"},
        {"roughness",
         "",
         false,
         {P::positive(
              "S_RING", "roughness of the raceway (m)",
              [](Raceway &p, Parameters &) -> double & { return p.ring_roughness; },
              "must be given"),
          P::non_negative(
              "S_BALL", "roughness of the ball (m)",
              [](Raceway &p, Parameters &) -> double & { return p.ball_roughness; },
              "must be given")}},
        {"regimes",
         "",
         false,
         {P::positive("LAMBDA_1", "lambda ratio at the end of the boundary regime",
                      [](Raceway &p, Parameters &) -> double & { return p.lambda_1; }),
          P::positive("LAMBDA_2", "lambda ratio at the start of the full film",
                      [](Raceway &p, Parameters &) -> double & { return p.lambda_2; })},
         [](const double *v) -> const char * {
           return v[1] <= v[0] ? "the second must be larger" : nullptr;
         }},
        {"inlet_shear",
         "",
         false,
         {P::one_of(
              "law of inlet shear", "murch|wilson|gupta",
              [](Raceway &p, Parameters &, int k) {
                const InletShear laws[] = {InletShear::murch, InletShear::wilson,
                                           InletShear::gupta};
                p.factors.inlet_shear = laws[k];
              },
              "no factor"),
          P::positive(
              "BETA", "relative change of viscosity -d(ln eta)/dT (1/K)",
              [](Raceway &p, Parameters &) -> double & { return p.factors.temperature_viscosity; },
              "no factor"),
          P::positive(
              "K_F", "thermal conductivity of the oil (W/(m K))",
              [](Raceway &p, Parameters &) -> double & { return p.factors.conductivity; },
              "no factor")},
         nullptr,
         "a factor on the film thickness, because the oil is heated at the inlet"},
        {"starvation",
         "",
         false,
         {P::within("PHI", "starvation factor on the film thickness", 1e-3, 1.0,
                    [](Raceway &p, Parameters &) -> double & { return p.factors.starvation; })}}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"h_min", "m", "minimum film thickness"}, &ContactState::h_min, Needs::film},
            {{"lambda", "", "lambda ratio"}, &ContactState::lambda, Needs::film},
            {{"regime", "", "0 boundary, 1 mixed, 2 full film", has_none, as_whole},
             [](const Raceway &p, const ContactState &s) {
               return double(regime({0.0, 0.0, p.lambda_1, p.lambda_2}, s.lambda));
             },
             Needs::film}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const bool in_gap = p.reach > 0.0;    // if the film is in the gap, these values have already
                                          // been computed by part_film_gap.h
    if (!in_gap) {
      const FilmPointT<B> at = film_point(c.entrainment, c.film_load);
      c.ln_speed = at.ln_speed;
      c.ln_film_load = at.ln_load;
    }
    const FilmPointT<B> at = {c.ln_speed, c.ln_film_load};
    c.h_min = film_thickness(k.film.min, at);
    if (p.factors.any) {
      if (!in_gap || p.factors.by_pressure) c.film_factor = film_factor(p, k, c, at);
      c.h_min = c.h_min * c.film_factor;
    }
    c.lambda = c.h_min * p.inverse_roughness;
  }
};

}    // namespace raceway
