// SPDX-License-Identifier: GPL-2.0-or-later
// Normal damping as in the paper: hysteresis, the film damper, and the resulting normal force N =
// max(0, Q + C rate) (damping.h). C is treated as constant in derivatives.
#pragma once

#include "part.h"

namespace raceway {

struct HysteresisPart : PartBase {
  static constexpr const char *name = "hysteresis";
  static constexpr When when = When::always;
  struct Parameters {
    double alpha_e = 0.08;    // s/m
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {
        {"hysteresis",
         "",
         false,
         {P::non_negative("ALPHA_E", "hysteretic damping alpha_e (s/m)",
                          [](Raceway &, Parameters &own) -> double & { return own.alpha_e; })}}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"damping", "N s/m", "normal damping by the material and the film", vanishes},
             &ContactState::damping}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    c.damping = hysteretic_damping(own.alpha_e, held(c.load));
  }
};

struct FilmDamperPart : PartBase {
  static constexpr const char *name = "film_damper", *slot = "film_damping";
  static constexpr When when = When::with_film;
  struct Parameters {
    double film_floor = -1.0;    // m, value set by the keyword; < 0: composite roughness
    double floor = 0.0;          // m, value in use
    void prepare(const Raceway &p) { floor = film_floor >= 0.0 ? film_floor : p.roughness; }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"film_damping", "eq5", true, {}, nullptr, "the film damper of the paper"},
            {"floor",
             "",
             false,
             {P::positive(
                 "H", "film floor of the damper (m)",
                 [](Raceway &, Parameters &own) -> double & { return own.film_floor; },
                 "composite roughness")},
             nullptr,
             "the film damper does not grow below this film thickness"},
            {"damper",
             "",
             false,
             {P::one_of("damper length", "a|2a",
                        [](Raceway &p, Parameters &, int k) { p.model.damper_full_axis = k == 1; }),
              P::one_of(
                  "damper radius", "Rb|Rx",
                  [](Raceway &p, Parameters &, int k) { p.model.damper_rolling_radius = k == 1; })},
             nullptr,
             "in eq (5)"}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    c.damping += film_damping(k.film_damper, Value<T>(k.a * held(c.root)), c.h_min, own.floor);
  }
};

// Column for all normal damping, i.e. damping by the steel, and by the film through either its
// damper or its branch.
struct DampingPower {
  static constexpr LossColumn column = {"damping_power", "film",
                                        "power dissipated by normal damping", true};
};

struct NormalForceLoss : DampingPower {
  // The energy stored in the film's branch is not dissipated here, because the branch has a
  // separate loss.
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    return (held(c.normal) - held(c.load) - c.film_force) * held(c.overlap_rate);
  }
};

struct NormalForcePart : PartBase {
  static constexpr const char *name = "normal_force";
  static constexpr When when = When::always;
  using Losses = LossList<NormalForceLoss>;

  static std::vector<StateColumn> columns()
  {
    return {{{"normal", "N", "normal force with damping", vanishes}, &ContactState::normal}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    const T N = c.load + c.damping * c.overlap_rate;
    c.normal = where(N > 0.0, N, 0.0);
  }
};

}    // namespace raceway
