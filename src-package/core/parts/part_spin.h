// SPDX-License-Identifier: GPL-2.0-or-later
// Couple that resists spin about the contact normal (spin.h).
//
// The derivative is the secant, i.e. the couple divided by the spin.
#pragma once

#include "../laws/spin.h"
#include "part_differential_slip.h"
#include "slip_parameters.h"

namespace raceway {

struct SpinPart : PartBase {
  static constexpr const char *name = "spin", *needs = "differential_slip";
  static constexpr bool couples = true;
  using Losses = LossList<SpinLoss>;
  struct Parameters {
    double share = 1.0;
    double modulus = 0.0;    // computed by prepare(): Pa, E'
    void prepare(const Raceway &p) { modulus = p.material.Eprime(); }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    return {{"spin",
             "",
             true,
             {share_of_spin<Parameters>()},
             nullptr,
             "couple about the contact normal if the contact angle causes spin"}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &own, const Raceway &p,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    using B = Value<T>;
    const B root = held(c.root), a = k.a * root;
    const B width = c.slip_width;    // from part_differential_slip.h, which acts earlier
    const B along = held(c.sliding_t), across = held(c.sliding_w);
    const B slide = square_root(B(along * along + across * across));
    const B speed = magnitude(held(c.spin_n)) * a;
    const B limit = own.share * c.mu * held(c.normal);
    const B couple = spin_couple(limit, own.modulus, root, k.a, k.b, k.K,
                                 B(p.rolling_radius(c.cos_angle)), p.transverse_radius());
    c.couple_n = B(couple * a / spin_growth(speed, width, slide)) * c.spin_n;
    // Spin leaves the force and its zero at the slip of free rolling as they are, and with them the
    // couple that balances the power of the force at that slip
    const B kept = -free_part * c.slip_curve * held(c.friction_t);
    const B share = slip_beside_spin(B(own.share * speed), width);
    const B taken = (c.slip_couple - kept) * (1.0 - share);
    c.slip_couple = c.slip_couple - taken;
    c.couple_w += B(-taken);
  }
};

}    // namespace raceway
