// SPDX-License-Identifier: GPL-2.0-or-later
// Oil drag on the balls (ball_drag.h), which depends on their speed relative to the outer ring. The
// reaction acts on the outer ring. A ball that does not touch the outer raceway has no drag; in a
// Gothic arch, the drag is assigned to the groove with the larger overlap. In derivatives, the drag
// force is treated as constant, because it changes the speed of a ball by at most a fraction of
// 1e-3 in an implicit step.
#pragma once

#include "../laws/ball_drag.h"
#include "part.h"

namespace raceway {

struct DragLoss {
  static constexpr LossColumn column = {"drag_power", "drag", "power dissipated by drag", false};
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    return c.drag_power;
  }
};

struct DragPart : PartBase {
  static constexpr const char *name = "drag";
  static constexpr bool needs_film = true, couples = true;
  using Losses = LossList<DragLoss>;
  struct Parameters {
    double density = 870.0, share = 0.0;       // density of the oil, kg/m^3; volume fraction of oil
                                               // in the bearing
    double reynolds = 0.0, prefactor = 0.0;    // computed by prepare(): s/m, N s^2/m^2
    DragTable table;
    void prepare(const Raceway &p)
    {
      const double R = p.groove.ball_radius;
      reynolds = density * 2.0 * R / p.model.lubricant.viscosity;
      prefactor = p.groove.side == Side::outer
                      ? 0.5 * share * density * 3.14159265358979323846 * R * R
                      : 0.0;
      table = drag_table();
    }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {{"drag",
             "",
             true,
             {P::positive("RHO", "density of the oil (kg/m^3)",
                          [](Raceway &, Parameters &own) -> double & { return own.density; }),
              P::within("X", "volume fraction of oil in the bearing", 0.0, 1.0,
                        [](Raceway &, Parameters &own) -> double & { return own.share; })},
             nullptr,
             "drag of oil and air on the balls"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {
        {{"drag", "N", "drag of oil and air on the ball, counted at the outer raceway", vanishes},
         &ContactState::drag,
         Needs::nothing,
         false}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    if (own.prefactor == 0.0) {
      c.drag = c.drag_power = B();
      return;
    }
    // speed of the ball's centre relative to the ring, along t
    const B v = held(c.sliding_t) - p.groove.ball_radius * held(c.roll_w);
    const B re = own.reynolds * magnitude(v);
    const B number = where(re > 1e-30, re, 1e-30);
    c.drag = own.prefactor * drag_coefficient(own.table, number) * v * (number / own.reynolds);
    if (p.groove.offset != 0.0) c.drag = where(deeper(p.groove.offset, c.z), c.drag, 0.0);
    c.drag_power = c.drag * v;
  }

 private:
  // Returns whether a ball at z (m) from its groove's centres has a smaller overlap with the twin
  // groove at -offset. A ball in the mid-plane, to rounding accuracy, is assigned to the groove
  // at the positive offset.
  template <class B> static RACEWAY_INLINE auto deeper(double offset, const B &z)
  {
    const B from_middle = z + offset;
    const double middle = 1e-9 * std::fabs(offset);
    return offset < 0.0 ? from_middle > middle : from_middle <= middle;
  }
};

}    // namespace raceway
