// SPDX-License-Identifier: GPL-2.0-or-later
// Couples against rolling, opposite on ball and ring (rolling_resistance.h). Through zero speed
// they are straight lines. The derivative is the couple over the speed: at rest, where it is large,
// an implicit step needs it.
#ifndef RACEWAY_PART_ROLLING_H
#define RACEWAY_PART_ROLLING_H

#include "part.h"
#include "rolling_resistance.h"

namespace raceway {

namespace detail {
constexpr double least_rolling = 1e-3;    // m/s: below it the couples grow with the speed

// 1/s, over the speed that a couple is divided by
template <class T> RACEWAY_INLINE T over_rolling(const T &turn, const T &radius)
{
  const T size = magnitude(turn), least = least_rolling / radius;
  return 1.0 / where(size > least, size, least);
}
}    // namespace detail

struct HydrodynamicRollingPart : PartBase {
  static constexpr const char *name = "rolling";
  static constexpr bool needs_film = true, couples = true;
  struct Parameters {
    double beta = 0.0, conductivity = 0.14, starvation = 1.0;    // 1/K, W/(m K), 1
    double ln_heating = 0.0;                                     // derived
    RollingConstants force;
    void prepare(const Raceway &p)
    {
      const double eta = p.model.lubricant.viscosity;
      ln_heating = std::log(beta * eta / conductivity);
      force = {eta, p.material.Eprime(), p.transverse_radius()};
    }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"rolling",
             "",
             true,
             {P::non_negative("BETA", "fall of ln(viscosity) with temperature (1/K)",
                              [](Raceway &, Parameters &own) -> double & { return own.beta; }),
              P::positive("K_F", "thermal conductivity of the oil (W/(m K))",
                          [](Raceway &, Parameters &own) -> double & { return own.conductivity; }),
              P::within("PHI_RS", "starvation factor of the rolling couple", 0.0, 1.0,
                        [](Raceway &, Parameters &own) -> double & { return own.starvation; })},
             nullptr,
             "hydrodynamic couple against rolling; BETA 0 is isothermal"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"rolling_power", "W", "power lost to the hydrodynamic couple", vanishes},
             [](const Raceway &, const ContactState &s) { return loss(s); },
             Needs::nothing,
             false}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B radius = p.rolling_radius(c.cos_angle), ln_u = logarithm(c.entrainment);
    const B f = rolling_force(own.force, ln_u, logarithm(held(c.load)), logarithm(radius));
    const B couple = 2.0 * own.starvation * f * radius * inlet_shear(own.ln_heating, ln_u);
    const T against = B(couple * detail::over_rolling(held(c.roll_w), radius)) * c.roll_w;
    c.rolling_couple = held(against);
    c.couple_w += against;
  }

  template <class T> static RACEWAY_INLINE Value<T> loss(const ContactStateT<T> &c)
  {
    return c.rolling_couple * held(c.roll_w);
  }
};

struct RollingHysteresisPart : PartBase {
  static constexpr const char *name = "rolling_hysteresis";
  static constexpr bool couples = true;
  struct Parameters {
    double alpha = 0.01;
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"rolling_hysteresis",
             "",
             true,
             {P::within("ALPHA", "share of elastic energy lost in rolling", 0.0, 0.5,
                        [](Raceway &, Parameters &own) -> double & { return own.alpha; })},
             nullptr,
             "couple of the steel against rolling"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {{{"hysteresis_power", "W", "power lost to hysteresis in rolling", vanishes},
             [](const Raceway &, const ContactState &s) { return loss(s); },
             Needs::nothing,
             false}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B couple = hysteresis_couple(own.alpha, held(c.load), B(k.b * held(c.root)));
    const B radius = p.rolling_radius(c.cos_angle);
    const T against = B(couple * detail::over_rolling(held(c.roll_w), radius)) * c.roll_w;
    c.hysteresis_couple = held(against);
    c.couple_w += against;
  }

  template <class T> static RACEWAY_INLINE Value<T> loss(const ContactStateT<T> &c)
  {
    return c.hysteresis_couple * held(c.roll_w);
  }
};

}    // namespace raceway

#endif
