// SPDX-License-Identifier: GPL-2.0-or-later
// Along rolling, this part applies differential slip; across rolling, it applies Coulomb's law with
// the slope in free rolling. Each acts in series with the contact's tangential spring k_t
// (Mindlin):
//   f' = k_t (s - f/c),  f <- f e^(-dt/tau) + c s (1 - e^(-dt/tau)),  tau = c/k_t,
// where s is the slip relative to free rolling and c is the secant of the slip law. The law acts as
// a slip law for dt >> tau, as a spring for dt << tau, and sticks at rest. |f| stays below mu N.
// The states are the forces in the frame that rotates with the ball's azimuth. In explicit steps
// only the spring acts, so both integrators support this law.
//
// In derivatives, mu, k_t, the ellipse and the shape of the secant are treated as constant, but N
// is not.
#pragma once

#include "slip_parameters.h"

namespace raceway {

struct DifferentialSlipPart : PartBase {
  static constexpr const char *name = "differential_slip", *slot = "tangential";
  static constexpr int states = 2;    // N, forces along t and w
  static constexpr bool couples = true;
  using Parameters = SlipParameters;
  using Losses = LossList<FrictionLoss>;

  static std::vector<Keyword<Parameters>> keywords()
  {
    return {{"heathcote",
             "",
             true,
             {least_slip_width<Parameters>()},
             nullptr,
             "after friction: differential slip in series with the tangential spring"}};
  }

  static std::vector<StateColumn> columns() { return tangential_columns(); }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &m,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B curve = k.a * k.a * held(c.compression) * own.lift;    // m, a^2/(2 R_d)
    const B turn = held(c.roll_w), forward = where(turn < 0.0, B() - 1.0, B() + 1.0);
    const B edge = magnitude(turn) * curve, width = where(edge > own.least, edge, own.least);
    c.slip_width = width;
    c.slip_curve = curve;
    const T along = c.sliding_t - turn * curve * free_part;
    const B off_t = held(along) * forward / width, off_w = held(c.sliding_w) / width;

    const auto [sharing, speed_t, speed_w] = slip_both_ways(off_t, off_w, width);
    const T cap = c.mu * c.normal, some = cap + none;
    const T ct = some * B(1.0 / speed_t), cw = some * B(1.0 / speed_w);

    c.kt = own.kt_ratio * c.stiffness;
    const B spring = m.dt * c.kt;
    T left_t, left_w;
    if (m.stage) {
      left_t = ct / (ct + spring);
      left_w = cw / (cw + spring);
    } else {
      const T part = -spring / some;
      left_t = left_of(part, speed_t);
      left_w = left_of(part, speed_w);
    }
    T ft = m.before[0] * left_t + ct * along * (1.0 - left_t);
    T fw = m.before[1] * left_w + cw * c.sliding_w * (1.0 - left_w);
    const B most = held(cap), size2 = held(ft) * held(ft) + held(fw) * held(fw);
    const B share = where(size2 > most * most, B(most / square_root(B(size2 + none))), B() + 1.0);
    c.friction_t = ft * share;
    c.friction_w = fw * share;
    m.after[0] = c.friction_t;
    m.after[1] = c.friction_w;

    // The couple depends on the slip after the spring and is computed from the force. If it were
    // computed from f/c, with c at the current sliding speed, oscillations of the spring would grow
    // in explicit steps.
    const B used = held(c.friction_t) * sharing * forward / (most + none);
    const B against = -slip_couple(force_root(used)) * most * curve * curve / width;    // N m s
    c.slip_couple = against * turn;
    c.couple_w += c.slip_couple + where(against > 0.0, against, 0.0) * (c.roll_w - turn);
  }

 private:
  // Returns the fraction of a force that remains after a time dt; part = -dt k_t/(mu N). A tiny
  // fraction has no derivative, because a contact may have no load.
  template <class T> static RACEWAY_INLINE T left_of(const T &part, const Value<T> &speed)
  {
    const T x = part * speed;
    return exponential(T(where(x < -100.0, -100.0, x)));
  }
  static constexpr double none = 1e-200;    // prevents 0/0 in a contact without load or friction
};

}    // namespace raceway
