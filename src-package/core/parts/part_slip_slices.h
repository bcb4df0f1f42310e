// SPDX-License-Identifier: GPL-2.0-or-later
// Combined differential slip, spin and sliding, summed over slices of the contact ellipse
// (slip_slices.h), in series with the contact's tangential spring k_t (Mindlin). This part is used
// instead of the closed-form solutions in part_differential_slip.h and part_spin.h, which treat
// slip and spin separately.
//
// The states are the forces f and the slip y after the spring, relative to free rolling:
//   y' = (s - y)/tau,  f' = (F(y) + c (s - y) - f)/tau,  tau = c/k_t,
// where s is the slip relative to free rolling and F is the sum over the slices. Hence f' = k_t (s
// - y) plus a relaxation towards F, which is a slip law for dt >> tau and a spring for dt << tau.
// Except for spin and roll, the slices depend only on y, which does not follow oscillations of the
// spring; the same applies to the couples. c is close to the slope of F in free rolling and always
// above half the slope of F; otherwise oscillations would grow.
//
// In derivatives, mu, k_t, c and the ellipse are treated as constant, but N is not.
#pragma once

#include "../laws/slip_slices.h"
#include "slip_parameters.h"

namespace raceway {

struct SlipSlicesPart : PartBase {
  static constexpr const char *name = "slip_slices", *slot = "tangential";
  static constexpr int states = 4;    // forces along t and w, N, and slips, m/s
  static constexpr bool couples = true;
  using Losses = LossList<FrictionLoss, SpinLoss>;
  struct Parameters : SlipParameters {
    double share = 1.0;
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    return {{"slices",
             "",
             true,
             {least_slip_width<Parameters>(), share_of_spin<Parameters>()},
             nullptr,
             "after friction, instead of heathcote and spin: slip and spin together, over slices "
             "of the contact ellipse"}};
  }

  static std::vector<StateColumn> columns() { return tangential_columns(); }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &m,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B a = k.a * held(c.root), curve = a * a * own.lift;    // m, a^2/(2 R_d)
    const B turn = held(c.roll_w), edge = turn * curve, spin = own.share * held(c.spin_n) * a;
    const B width = where(magnitude(edge) > own.least, magnitude(edge), own.least);
    const T along = c.sliding_t - free_part * edge;
    const T cap = c.mu * c.normal;
    const B most = held(cap);

    c.kt = own.kt_ratio * c.stiffness;
    const B unit = most / width, part = spin / width, spring = m.dt * c.kt;
    const B ct = unit * lean(free_lean, 1.3, part) + none, cw = unit * lean(13.0, 2.5, part) + none;
    const B left_t = left_of(spring, ct, m.stage), left_w = left_of(spring, cw, m.stage);
    const T slip_t = m.before[2] * left_t + along * (1.0 - left_t);
    const T slip_w = m.before[3] * left_w + c.sliding_w * (1.0 - left_w);

    constexpr bool slopes = !std::is_same<T, B>::value;
    const auto f = SlipSlices::forces<slopes>(SlipMotionT<B>{held(slip_t) + free_part * edge,
                                                             held(slip_w), spin, edge, k.b / k.a,
                                                             B() + own.least / free_lean});
    const T to_t =
        cap * (f.along + f.slope_along * (slip_t - held(slip_t))) + ct * (along - slip_t);
    const T to_w =
        cap * (f.across + f.slope_across * (slip_w - held(slip_w))) + cw * (c.sliding_w - slip_w);
    const T ft = m.before[0] * left_t + to_t * (1.0 - left_t);
    const T fw = m.before[1] * left_w + to_w * (1.0 - left_w);
    const B size2 = held(ft) * held(ft) + held(fw) * held(fw);
    const B kept = where(size2 > most * most, B(most / square_root(B(size2 + none))), B() + 1.0);
    c.friction_t = ft * kept;
    c.friction_w = fw * kept;
    m.after[0] = c.friction_t;
    m.after[1] = c.friction_w;
    m.after[2] = slip_t;
    m.after[3] = slip_w;

    const B lever = own.share * most * a;
    c.couple_n =
        lever * f.moment + B(lever * own.share * a * f.slope_moment) * (c.spin_n - held(c.spin_n));
    c.slip_couple = most * curve * f.couple;
    c.couple_w += c.slip_couple + B(most * curve * curve * f.slope_couple) * (c.roll_w - turn);
  }

 private:
  // Returns c times the width divided by mu N, as a function of spin divided by the width. Along
  // rolling, the value is 3.80 if there is no spin. Across rolling, the sliding direction reverses
  // in few slices, so the slope is steep.
  template <class B> static RACEWAY_INLINE B lean(double most, double falls, const B &spin)
  {
    const B x = falls * spin;
    return most / square_root(B(1.0 + x * x));
  }
  // Returns the fraction of a state that remains after a time dt (LawStates); spring = dt k_t.
  template <class B> static RACEWAY_INLINE B left_of(const B &spring, const B &c, bool stage)
  {
    if (stage) return c / (c + spring);
    const B x = -spring / c;
    return exponential(B(where(x < -100.0, -100.0, x)));
  }
  static constexpr double none = 1e-200;    // prevents 0/0 in a contact without load or friction
};

}    // namespace raceway
