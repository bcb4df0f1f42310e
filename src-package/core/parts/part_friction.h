// SPDX-License-Identifier: GPL-2.0-or-later
// Friction (friction.h): a coefficient that is constant or a function of the lambda ratio, and a
// tangential law, either a spring with history or Coulomb's law smoothed over a creep speed.
//
// The derivative of the smoothed law is the secant f/s: mu, v_0 and the denominator are treated as
// constant, but N is not. For a sliding contact the tangent is nearly flat, so a single correction
// based on the tangent would move a light ball far past zero sliding.
#pragma once

#include "../laws/friction.h"
#include "part.h"

namespace raceway {

// Loss in any tangential law. Energy stored in a spring is counted as dissipated until it is
// released.
struct FrictionLoss {
  static constexpr LossColumn column = {"friction_power", "slip",
                                        "power dissipated by the tangential force", true};
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    const Value<T> slid =
        held(c.friction_t) * held(c.sliding_t) + held(c.friction_w) * held(c.sliding_w);
    const Value<T> turned = c.slip_couple * held(c.roll_w);
    return where(turned == 0.0, slid, Value<T>(slid + turned));
  }
};

// Loss in any spin law.
struct SpinLoss {
  static constexpr LossColumn column = {"spin_power", "spin", "power dissipated by spin", false};
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    return held(c.couple_n) * held(c.spin_n);
  }
};

// Columns that are common to all laws for the friction coefficient, and columns that are common to
// all tangential laws.
inline std::vector<StateColumn> coefficient_columns()
{
  return {{{"mu", "", "friction coefficient"}, &ContactState::mu}};
}
inline std::vector<StateColumn> tangential_columns()
{
  return {{{"friction", "N", "tangential force", vanishes},
           [](const Raceway &, const ContactState &s) {
             return std::hypot(s.friction_t, s.friction_w);
           }},
          {{"friction_t", "N", "tangential force along rolling, on the ring", vanishes},
           &ContactState::friction_t,
           Needs::nothing,
           false},
          {{"friction_w", "N", "tangential force across rolling, on the ring", vanishes},
           &ContactState::friction_w,
           Needs::nothing,
           false}};
}

struct ConstantFrictionPart : PartBase {
  static constexpr const char *name = "friction_constant", *slot = "friction";
  struct Parameters {
    double mu = 0.0;
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"friction",
             "constant",
             true,
             {P::within("MU", "friction coefficient", 0.0, 2.0,
                        [](Raceway &, Parameters &own) -> double & { return own.mu; })}}};
  }

  static std::vector<StateColumn> columns() { return coefficient_columns(); }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    c.mu = Value<T>() + own.mu;
  }
};

struct StribeckFrictionPart : PartBase {
  static constexpr const char *name = "friction_stribeck", *slot = "friction";
  static constexpr bool needs_film = true;
  struct Parameters {
    StribeckCurve curve;
    void prepare(const Raceway &p)
    {
      curve.lambda_1 = p.lambda_1;
      curve.lambda_2 = p.lambda_2;
    }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {
        {"friction",
         "stribeck",
         true,
         {P::within("MU_BOUNDARY", "boundary friction coefficient", 0.0, 2.0,
                    [](Raceway &, Parameters &own) -> double & { return own.curve.mu_boundary; }),
          P::within("MU_FULL", "full-film friction coefficient", 0.0, 2.0,
                    [](Raceway &, Parameters &own) -> double & { return own.curve.mu_full; })}}};
  }

  static std::vector<StateColumn> columns() { return coefficient_columns(); }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    c.mu = stribeck(own.curve, c.lambda);
  }
};

struct TangentialSpringPart : PartBase {
  static constexpr const char *name = "tangential_spring", *slot = "tangential";
  static constexpr int states = 2;    // m, elongation along t and w
  static constexpr bool explicit_step = true;
  using Losses = LossList<FrictionLoss>;
  struct Parameters {
    double ratio = -1.0;    // k_t/k_n set by the keyword; < 0: Mindlin
    double zeta = 0.3;      // dashpot constant relative to critical damping of the rolling mode,
                            // whose mass is 2/7 m_b
    double kt_ratio = 0.0, ct_factor = 0.0;    // values in use
    void prepare(const Raceway &p)
    {
      kt_ratio = ratio >= 0.0 ? ratio
                              : tangential_ratio(p.material.ball_young, p.material.ball_poisson,
                                                 p.material.ring_young, p.material.ring_poisson);
      ct_factor = 2.0 * zeta * std::sqrt(2.0 / 7.0 * p.ball_mass);
    }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"tangential",
             "",
             false,
             {P::positive(
                  "KT_OVER_KN", "ratio of tangential to normal stiffness",
                  [](Raceway &, Parameters &own) -> double & { return own.ratio; }, "Mindlin"),
              P::within("ZETA", "tangential damping ratio", 0.0, 2.0,
                        [](Raceway &, Parameters &own) -> double & { return own.zeta; })}}};
  }

  static std::vector<StateColumn> columns() { return tangential_columns(); }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &m,
                                 ContactStateT<T> &c)
  {
    c.kt = own.kt_ratio * c.stiffness;
    c.ct = own.ct_factor * square_root(c.kt);
    m.after[0] = m.before[0] + m.dt * c.sliding_t;
    m.after[1] = m.before[1] + m.dt * c.sliding_w;
    tangential_force(TangentialSpringT<T>{c.kt, c.ct}, T(c.mu * c.normal), c.sliding_t, c.sliding_w,
                     m.after, c.friction_t, c.friction_w);
  }
};

struct SmoothedFrictionPart : PartBase {
  static constexpr const char *name = "smoothed_friction", *slot = "tangential";
  using Losses = LossList<FrictionLoss>;
  struct Parameters {
    double creep = 0.01;          // v_0 = creep * entrainment speed
    double creep_floor = 1e-4;    // m/s, lower limit of v_0, needed for a bearing at rest
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"smoothed",
             "",
             true,
             {P::within("CREEP", "creep of the smoothed friction", 1e-6, 1.0,
                        [](Raceway &, Parameters &own) -> double & { return own.creep; })},
             nullptr,
             "after friction: Coulomb's law without history, smoothed over this slide-roll ratio"}};
  }

  static std::vector<StateColumn> columns() { return tangential_columns(); }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    const Value<T> u = own.creep * c.entrainment;
    c.v_0 = square_root(u * u + own.creep_floor * own.creep_floor);
    c.kt = Value<T>();
    c.ct = smoothed_friction(T(c.mu * c.normal), held(c.sliding_t), held(c.sliding_w), c.v_0);
    c.friction_t = c.ct * c.sliding_t;
    c.friction_w = c.ct * c.sliding_w;
  }
};

}    // namespace raceway
