// SPDX-License-Identifier: GPL-2.0-or-later
// Couples that resist rolling (rolling_resistance.h). They are equal and opposite on ball and ring,
// and linear in the speed near zero speed. Their derivative is the secant, i.e. the couple divided
// by the speed. It is large at rest, as is necessary in an implicit step.
#pragma once

#include "../laws/rolling_inlet.h"
#include "../laws/rolling_resistance.h"
#include "part_film.h"

namespace raceway {

namespace detail {
constexpr double least_rolling = 1e-3;    // speed (m/s) below which the couples are proportional to
                                          // the speed

// Returns the inverse of the angular speed by which a couple is divided, s.
template <class T> RACEWAY_INLINE T over_rolling(const T &turn, const T &radius)
{
  const T size = magnitude(turn), least = least_rolling / radius;
  return 1.0 / where(size > least, size, least);
}
}    // namespace detail

struct HydrodynamicRollingLoss {
  static constexpr LossColumn column = {"rolling_power", "rolling",
                                        "power dissipated by the hydrodynamic couple", false};
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    return c.rolling_couple * held(c.roll_w);
  }
};

struct HydrodynamicRollingPart : PartBase {
  static constexpr const char *name = "rolling";
  static constexpr bool needs_film = true, couples = true;
  using Losses = LossList<HydrodynamicRollingLoss>;
  struct Parameters {
    double beta = 0.0, conductivity = 0.14, starvation = 1.0;    // 1/K, W/(m K), 1
    double length = 0.0;    // inlet length in units of the semi-axis b; 0: flooded
    // computed by prepare()
    double ln_heating = 0.0;
    RollingConstants force;
    RollingShapeT<double> radial{};    // at zero contact angle
    RollingInlet inlet;
    void prepare(const Raceway &p)
    {
      const double eta = p.model.lubricant.viscosity;
      ln_heating = std::log(beta * eta / conductivity);
      force = {eta, p.material.Eprime(), p.transverse_radius()};
      radial = rolling_shape(force, p.rolling_radius(1.0));
      inlet.prepare(length);
    }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {
        {"rolling",
         "",
         true,
         {P::non_negative("BETA", "decrease of ln(viscosity) with temperature (1/K)",
                          [](Raceway &, Parameters &own) -> double & { return own.beta; }),
          P::positive("K_F", "thermal conductivity of the oil (W/(m K))",
                      [](Raceway &, Parameters &own) -> double & { return own.conductivity; }),
          P::within("PHI_RS", "starvation factor of the rolling couple", 0.0, 1.0,
                    [](Raceway &, Parameters &own) -> double & { return own.starvation; })},
         nullptr,
         "hydrodynamic couple that resists rolling; BETA 0 is isothermal"},
        {"rolling_inlet",
         "",
         false,
         {P::within(
             "LENGTH", "inlet length of a rolling contact over semi-axis b; 1: shortest", 1.0, 1e6,
             [](Raceway &, Parameters &own) -> double & { return own.length; }, "flooded")},
         nullptr,
         "after rolling: reduces the hydrodynamic couple to that of an inlet of this length"}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B radius = p.rolling_radius(c.cos_angle);
    const B root = k.K * k.unit * held(c.root);    // cube root of the load
    const B f =
        rolling_force(shape(own, p, c.cos_angle, radius), c.ln_speed, B(held(c.load)), root);
    const B shear = rolling_inlet_shear(B(own.ln_heating + 2.0 * c.ln_speed));
    B couple = 2.0 * own.starvation * f * radius * shear;
    if (own.inlet.short_inlet)
      couple = couple * own.inlet.share(held_central_film(p, k, c), B(k.b * held(c.root)), radius);
    const T against = B(couple * detail::over_rolling(held(c.roll_w), radius)) * c.roll_w;
    c.rolling_couple = held(against);
    c.couple_w += against;
  }

 private:
  // Returns the geometry factors; at zero contact angle they are exact, as are the constants of a
  // raceway.
  template <class B>
  static RACEWAY_INLINE RollingShapeT<B> shape(const Parameters &own, const Raceway &p,
                                               const B &cos_angle, const B &radius)
  {
    const auto oblique = 1.0 - cos_angle >= 1e-12;
    if (any(oblique))
      return rolling_shape(own.force, B(where(oblique, radius, p.rolling_radius(1.0))));
    const B n = B();
    return {n + own.radial.rigid, n + own.radial.elastic, n + own.radial.mean};
  }
};

struct RollingHysteresisLoss {
  static constexpr LossColumn column = {"hysteresis_power", "hysteresis",
                                        "power dissipated by hysteresis in rolling", false};
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    return c.hysteresis_couple * held(c.roll_w);
  }
};

struct RollingHysteresisPart : PartBase {
  static constexpr const char *name = "rolling_hysteresis";
  static constexpr bool couples = true;
  using Losses = LossList<RollingHysteresisLoss>;
  struct Parameters {
    double alpha = 0.01;
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"rolling_hysteresis",
             "",
             true,
             {P::within("ALPHA", "fraction of elastic energy lost in rolling", 0.0, 0.5,
                        [](Raceway &, Parameters &own) -> double & { return own.alpha; })},
             nullptr,
             "couple that resists rolling due to hysteresis of the steel"}};
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
};

}    // namespace raceway
