// SPDX-License-Identifier: GPL-2.0-or-later
// A contact law that consists of any set of parts and is evaluated in lanes. Each part is a
// separate function that is compiled once (any_law_parts.h), and the parts of the set are called
// one after another. The results are bitwise identical to those of a law compiled as a whole
// (contact.h), but computing them takes 1.3 to 1.9 times as long.
#pragma once

#include "../parts/part.h"
#include "../raceway/raceway_physics.h"

namespace raceway {

struct LawFunctions {
  template <class T>
  using Act = void (*)(unsigned parts, const RacewayPhysics &, const RacewayConstantsT<Value<T>> &,
                       LawStates<T>, ContactStateT<T> &);
  Act<Lane> act;
  Act<Dual<Lane, 3>> act_3;
  Act<Dual<Lane, 6>> act_6;
  void (*misses)(unsigned parts, const RacewayPhysics &, const RacewayConstantsT<Lane> &,
                 ContactStateT<Lane> &, LaneMask &);
  void (*beyond)(unsigned parts, const RacewayPhysics &, const ContactStateT<Lane> &, Lane &);
  void (*energy)(unsigned parts, const RacewayPhysics &, const ContactStateT<Lane> &, Lane &);
  void (*loss)(unsigned parts, const ContactStateT<Lane> &, Lane &);
};
extern const LawFunctions wide_law, narrow_law;    // narrow: for processors without AVX2

// Has the same members as LawOf (law.h). n is the number of motions on which the forces depend, 3
// or 6.
template <int n> class AnyLaw {
 public:
  static constexpr int room = most_states, motions = n;
  static constexpr bool couples = n == 6, takes_profiles = true;
  const int states;
  const bool decides;

  RACEWAY_INLINE AnyLaw(unsigned parts, const LawFacts &facts, const LawFunctions &functions) :
      states(facts.states), decides(facts.decides), parts_(parts), f_(functions)
  {
  }

  RACEWAY_INLINE void act(const RacewayPhysics &p, const RacewayConstantsT<Lane> &k,
                          const LawStates<Lane> &m, ContactStateT<Lane> &c) const
  {
    f_.act(parts_, p, k, m, c);
  }
  RACEWAY_INLINE void act(const RacewayPhysics &p, const RacewayConstantsT<Lane> &k,
                          const LawStates<Dual<Lane, n>> &m, ContactStateT<Dual<Lane, n>> &c) const
  {
    if constexpr (couples) f_.act_6(parts_, p, k, m, c);
    else f_.act_3(parts_, p, k, m, c);
  }
  RACEWAY_INLINE LaneMask misses(const RacewayPhysics &p, const RacewayConstantsT<Lane> &k,
                                 ContactStateT<Lane> &c) const
  {
    LaneMask some;
    f_.misses(parts_, p, k, c, some);
    return some;
  }
  RACEWAY_INLINE Lane beyond(const RacewayPhysics &p, const ContactStateT<Lane> &c) const
  {
    Lane result;
    f_.beyond(parts_, p, c, result);
    return result;
  }
  RACEWAY_INLINE Lane energy(const RacewayPhysics &p, const ContactStateT<Lane> &c) const
  {
    Lane sum;
    f_.energy(parts_, p, c, sum);
    return sum;
  }
  RACEWAY_INLINE Lane loss(const ContactStateT<Lane> &c) const
  {
    Lane sum;
    f_.loss(parts_, c, sum);
    return sum;
  }

 private:
  const unsigned parts_;
  const LawFunctions &f_;
};

// Calls f(law) with the law for a set of parts.
template <class F>
RACEWAY_INLINE void with_any_law(unsigned parts, const LawFunctions &functions, const F &f)
{
  const LawFacts facts = law_facts(parts);
  if (facts.couples) f(AnyLaw<6>(parts, facts, functions));
  else f(AnyLaw<3>(parts, facts, functions));
}

}    // namespace raceway
