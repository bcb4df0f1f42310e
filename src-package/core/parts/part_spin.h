// SPDX-License-Identifier: GPL-2.0-or-later
// Couple against spin about the contact normal (docs/theory, Spin), (3/8) mu Q a E for pure spin
// under Coulomb's law, E the complete elliptic integral of the ellipse.
//
// If the contact also slides, the couple at small spin is proportional to the spin. Gauss points
// over the ellipse (python: theory/spin) give the width: omega a = 0.78 s_e with differential slip,
// omega a = 1.9 s with gross sliding. Spin in turn reduces the couple of differential slip, by the
// factor 1 - 1.35 (omega a/s_e)^2. Moment and power agree with the Gauss points within 5 % of mu Q
// a and mu Q s_e.
//
// The derivative is the couple over the spin.
#ifndef RACEWAY_PART_SPIN_H
#define RACEWAY_PART_SPIN_H

#include "part_differential_slip.h"
#include "slip_parameters.h"

namespace raceway {

// N m, from mu Q and the constants of Hertz: with K, a and b in hand E needs no evaluation,
//   (3/8) mu Q a E = mu Q sqrt(delta) pi E' a^2 b^2 (1/R_x + 1/R_y)/(16 K),
// a and b over sqrt(delta).
template <class T>
RACEWAY_INLINE T spin_couple(const T &limit, double modulus, const T &root, const T &a, const T &b,
                             const T &K, const T &rolling_radius, double transverse_radius)
{
  const T ab = a * b, curvature = 1.0 / rolling_radius + 1.0 / transverse_radius;
  return limit * root * (3.14159265358979323846 / 16.0 * modulus) * ab * ab * curvature / K;
}

// The same from a known E.
inline double pure_spin_couple(double limit, double a, double E) { return 0.375 * limit * a * E; }

// fits: omega a over s_e up to which the couple grows, and the share of slip's couple that is lost
constexpr double spin_width = 0.78, spin_loss = 1.35;

struct SpinPart : PartBase {
  static constexpr const char *name = "spin", *needs = "differential_slip";
  static constexpr bool couples = true;
  using Losses = LossList<SpinLoss>;
  struct Parameters {
    double share = 1.0;
    double modulus = 0.0;    // derived: Pa, E'
    void prepare(const Raceway &p) { modulus = p.material.Eprime(); }
  };

  static std::vector<Keyword<Parameters>> keywords()
  {
    return {{"spin",
             "",
             true,
             {share_of_spin<Parameters>()},
             nullptr,
             "couple about the contact normal, where the contact angle makes spin"}};
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
    const B slip = 1.9 * square_root(B(along * along + across * across));
    const B wide = spin_width * width, speed = magnitude(held(c.spin_n)) * a;
    const B denominator = where(wide > slip, wide, slip);
    const B limit = own.share * c.mu * held(c.normal);
    const B couple = spin_couple(limit, own.modulus, root, k.a, k.b, k.K,
                                 B(p.rolling_radius(c.cos_angle)), p.transverse_radius());
    c.couple_n = B(couple * a / where(speed > denominator, speed, denominator)) * c.spin_n;
    const B x = own.share * speed / width, rest = 1.0 - spin_loss * x * x;
    const B taken = c.slip_couple * (1.0 - where(rest > 0.0, rest, 0.0));
    c.slip_couple = c.slip_couple - taken;
    c.couple_w += B(-taken);
  }
};

}    // namespace raceway

#endif
