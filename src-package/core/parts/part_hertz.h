// SPDX-License-Identifier: GPL-2.0-or-later
// The elastic contact: Q = K compression^1.5 (hertz.h).
#pragma once

#include "part.h"

namespace raceway {

struct HertzContactPart : PartBase {
  static constexpr const char *name = "hertz", *slot = "elastic";
  static constexpr When when = When::always;

  static std::vector<Keyword<Parameters>> keywords()
  {
    using P = Parameter<Parameters>;
    return {
        {"young",
         "",
         false,
         {P::within("E_BALL", "Young's modulus of the ball (Pa)", LEAST_YOUNG, LARGEST_YOUNG,
                    [](Raceway &p, Parameters &) -> double & { return p.material.ball_young; }),
          P::within("E_RING", "Young's modulus of the ring (Pa)", LEAST_YOUNG, LARGEST_YOUNG,
                    [](Raceway &p, Parameters &) -> double & { return p.material.ring_young; })}},
        {"poisson",
         "",
         false,
         {P::within("NU_BALL", "Poisson's ratio of the ball", 0.0, 0.5,
                    [](Raceway &p, Parameters &) -> double & { return p.material.ball_poisson; }),
          P::within("NU_RING", "Poisson's ratio of the ring", 0.0, 0.5,
                    [](Raceway &p, Parameters &) -> double & { return p.material.ring_poisson; })}},
        {"ellipse",
         "",
         false,
         {P::one_of(
             "ellipse", "exact|hamrock|printed",
             [](Raceway &p, Parameters &, int k) { p.model.ellipse = static_cast<Ellipse>(k); })},
         nullptr,
         "elliptic integrals, Hamrock and Brewe\'s fit, or the fit as printed in the paper"}};
  }

  static std::vector<StateColumn> columns()
  {
    return {
        {{"load", "N", "elastic contact load", vanishes}, &ContactState::load},
        {{"stiffness", "N/m", "derivative of the load with respect to the overlap", vanishes},
         &ContactState::stiffness,
         Needs::nothing,
         false},
        {{"a", "m", "semi-axis of the contact ellipse across the groove", vanishes},
         [](const Raceway &p, const ContactState &s) { return p.law.at(s.cos_angle).a * s.root; }},
        {{"b", "m", "semi-axis of the contact ellipse along rolling", vanishes},
         [](const Raceway &p, const ContactState &s) { return p.law.at(s.cos_angle).b * s.root; }},
        {{"pressure", "Pa", "largest Hertz pressure", vanishes},
         [](const Raceway &p, const ContactState &s) { return p.law.at(s.cos_angle).p * s.root; }}};
  }

  template <class T>
  static RACEWAY_INLINE void act(const Parameters &, const Raceway &,
                                 const RacewayConstantsT<Value<T>> &k, const LawStates<T> &,
                                 ContactStateT<T> &c)
  {
    c.root = square_root(c.compression);
    c.load = k.K * c.compression * c.root;
    c.stiffness = 1.5 * k.K * held(c.root);
    c.film_load = held(c.load);
  }

  template <class T>
  static RACEWAY_INLINE Value<T> energy(const Parameters &, const Raceway &,
                                        const ContactStateT<T> &c)
  {
    return 0.4 * held(c.load) * held(c.compression);
  }
};

}    // namespace raceway
