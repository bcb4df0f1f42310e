// SPDX-License-Identifier: GPL-2.0-or-later
// Friction coefficient of a contact that asperities and film share (asperities.h). The derivative
// holds it.
#ifndef RACEWAY_PART_MIXED_FRICTION_H
#define RACEWAY_PART_MIXED_FRICTION_H

#include "asperities.h"
#include "part_friction.h"

namespace raceway {

struct MixedFrictionPart : PartBase {
  static constexpr const char *name = "friction_mixed", *slot = "friction";
  static constexpr bool needs_film = true;
  struct Parameters {
    double mu_boundary = 0.12, mu_film = 0.05;
    Asperities asperities;
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
             {P::within("B", "factor of the asperity share", 0.01, 100.0,
                        [](Raceway &, Parameters &own) -> double & { return own.asperities.b; }),
              P::within("C", "exponent of the asperity share", 0.01, 10.0,
                        [](Raceway &, Parameters &own) -> double & { return own.asperities.c; })},
             nullptr,
             "of friction mixed: exp(-B lambda^C)"}};
  }

  static std::vector<StateColumn> columns()
  {
    std::vector<StateColumn> list = coefficient_columns();
    list.push_back({{"asperity_share", "", "share of the load that asperities carry"},
                    [](const Raceway &, const ContactState &s) { return s.asperity_share; },
                    Needs::film,
                    false});
    return list;
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    c.asperity_share = raceway::asperity_share(own.asperities, c.lambda);
    c.mu = own.mu_film + (own.mu_boundary - own.mu_film) * c.asperity_share;
  }
};

}    // namespace raceway

#endif
