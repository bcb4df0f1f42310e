// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluates the contact law for any set of parts (core/contact/any_law.h), for every number type
// used in the tests.
#pragma once

#include "../../src-package/core/contact/any_law_parts.h"
#include "../../src-package/core/contact/contact_slopes.h"

namespace raceway {
namespace {

template <int n> struct PartsLaw {
  static constexpr int room = most_states, motions = n;
  static constexpr bool couples = n == 6;
  unsigned parts;
  int states = law_facts(parts).states;
  bool decides = law_facts(parts).decides;

  template <class T>
  void act(const RacewayPhysics &p, const RacewayConstantsT<Value<T>> &k, const LawStates<T> &m,
           ContactStateT<T> &c) const
  {
    act_all(Parts(), p, k, m, c);
  }
  bool misses(const RacewayPhysics &p, const RacewayConstants &k, ContactState &c) const
  {
    return misses_all(Parts(), p, k, c);
  }
  double loss(const ContactState &c) const { return loss_all(Parts(), c); }

 private:
  template <class T, class... P>
  void act_all(PartList<P...>, const RacewayPhysics &p, const RacewayConstantsT<Value<T>> &k,
               const LawStates<T> &m, ContactStateT<T> &c) const
  {
    act_one_by_one<T, P...>(parts, p, k, m, c);
  }
  template <class... P>
  bool misses_all(PartList<P...>, const RacewayPhysics &p, const RacewayConstants &k,
                  ContactState &c) const
  {
    bool some = false;
    any_misses<double, bool, P...>(parts, p, k, c, some);
    return some;
  }
  template <class... P> double loss_all(PartList<P...>, const ContactState &c) const
  {
    double sum;
    any_loss<double, P...>(parts, c, sum);
    return sum;
  }
};

// Calls f(law) with the law that consists of a set of parts.
template <class F> void with_parts(unsigned parts, const F &f)
{
  if (law_facts(parts).couples) f(PartsLaw<6>{parts});
  else f(PartsLaw<3>{parts});
}

// Sets the motions of a contact at a given position; returns whether the contact is open.
template <class L>
bool approach(const L &law, const RacewayPhysics &p, const BallState &ball, const RingState &ring,
              ContactState &c)
{
  find_motions<L::couples>(p, ball, ring, c);
  return law.decides && law.misses(p, p.law.at(c.cos_angle), c);
}

}    // namespace
}    // namespace raceway
