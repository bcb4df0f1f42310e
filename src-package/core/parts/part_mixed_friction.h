// SPDX-License-Identifier: GPL-2.0-or-later
// Friction coefficient of a contact whose load is shared by the asperities and the film
// (asperities.h). The coefficient of the film is either a constant or follows from the Eyring
// stress up to a limiting shear stress (film_traction.h). The latter is evaluated at the sliding
// speed that results from free rolling and the sliding of the contact. The friction coefficient is
// treated as constant in derivatives.
#pragma once

#include "../laws/asperities.h"
#include "../laws/differential_slip.h"
#include "../laws/film_traction.h"
#include "part_film.h"
#include "part_friction.h"

namespace raceway {

struct MixedFrictionPart : PartBase {
  static constexpr const char *name = "friction_mixed", *slot = "friction";
  static constexpr bool needs_film = true;
  struct Parameters {
    double mu_boundary = 0.12, mu_film = 0.05;
    Asperities asperities;
    FilmTraction traction;
    double lift = 0.0;    // computed by prepare(); 1/m, 1/(2 R_d)
    void prepare(const Raceway &p)
    {
      traction.prepare(p.model.lubricant);
      lift = 0.5 / deformed_radius(p.groove.groove_radius, p.groove.ball_radius);
    }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"friction",
             "mixed",
             true,
             {P::within("MU_BOUNDARY", "boundary friction coefficient", 0.0, 2.0,
                        [](Raceway &, Parameters &own) -> double & { return own.mu_boundary; }),
              P::within("MU_FILM", "friction coefficient of the film", 0.0, 2.0,
                        [](Raceway &, Parameters &own) -> double & { return own.mu_film; })}},
            {"asperities",
             "",
             false,
             {P::within("B", "factor in the asperity fraction", 0.01, 100.0,
                        [](Raceway &, Parameters &own) -> double & { return own.asperities.b; }),
              P::within("C", "exponent in the asperity fraction", 0.01, 10.0,
                        [](Raceway &, Parameters &own) -> double & { return own.asperities.c; })},
             nullptr,
             "for friction mixed: the asperity fraction is exp(-B lambda^C)"},
            {"asperity_law",
             "",
             false,
             {P::one_of("law for the asperity fraction", "zhou|clarke",
                        [](Raceway &, Parameters &own, int k) {
                          own.asperities.law = static_cast<AsperityLaw>(k);
                        })},
             nullptr,
             "for friction mixed: the asperity fraction is exp(-B lambda^C) or 1 - erf(lambda)"},
            {"traction",
             "",
             false,
             {P::positive(
                  "TAU_0", "Eyring stress of the film (Pa)",
                  [](Raceway &, Parameters &own) -> double & { return own.traction.stress; },
                  "MU_FILM"),
              P::within(
                  "LAMBDA_L", "ratio of limiting shear stress to pressure", 1e-3, 1.0,
                  [](Raceway &, Parameters &own) -> double & { return own.traction.limit; },
                  "MU_FILM")},
             nullptr,
             "for friction mixed: Eyring's law with a limiting shear stress instead of MU_FILM"}};
  }

  static std::vector<StateColumn> columns()
  {
    std::vector<StateColumn> list = coefficient_columns();
    list.push_back({{"asperity_share", "", "fraction of the load carried by asperities"},
                    &ContactState::asperity_share,
                    Needs::film,
                    false});
    return list;
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    // ln Lambda is computed from the film equation, because lambda itself is computed later
    Value<T> ln_lambda = ln_film_thickness(k.film.min, {c.ln_speed, c.ln_film_load});
    if (p.factors.any) ln_lambda = ln_lambda + logarithm(c.film_factor);
    c.asperity_share =
        raceway::asperity_share(own.asperities, Value<T>(ln_lambda + p.ln_inverse_roughness));
    if (own.traction.asked()) {
      const Value<T> mu_film = coefficient(own, p, k, c);
      c.mu = mixed_friction(own.mu_boundary, mu_film, c.asperity_share);
    } else {
      c.mu = mixed_friction(own.mu_boundary, own.mu_film, c.asperity_share);
    }
  }

 private:
  // Returns the friction coefficient of the film.
  template <class T>
  static RACEWAY_INLINE Value<T> coefficient(const Parameters &own, const Raceway &p,
                                             const RacewayConstantsT<Value<T>> &k,
                                             const ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B root = held(c.root), turn = held(c.roll_w);
    const B edge = turn * k.a * k.a * held(c.compression) * own.lift;    // m/s, s_e
    const B along = held(c.sliding_t) - free_part * edge, across = held(c.sliding_w);
    const B free = free_speed * edge;
    const B slid2 = free * free + along * along + across * across + 1e-30;
    const B h = held_central_film(p, k, c);
    return own.traction.coefficient(B(k.p * root), B(0.5 * logarithm(slid2) - logarithm(h)));
  }
};

}    // namespace raceway
