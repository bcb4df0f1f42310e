// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of the contact law as functions, for the files that compile any_law.h. Each of these
// files has its own copy, because the files are compiled for different instruction sets.
#pragma once

#include "any_law.h"
#include "contact.h"

#define RACEWAY_CALLED RACEWAY_WIDE __attribute__((noinline))

namespace raceway {
namespace {

template <class Part, class T>
RACEWAY_CALLED void call_act(const RacewayPhysics &p, const RacewayConstantsT<Value<T>> &k,
                             const LawStates<T> &m, ContactStateT<T> &c)
{
  Part::act(p.of<Part>(), p, k, m, c);
}

// Selects the parts that are available for a number type. Numbers with three derivatives are used
// only for laws without couples, and numbers with derivatives only for parts that support implicit
// integration.
template <class Part, class T> struct Takes : std::true_type {};
template <class Part, class B, int n>
struct Takes<Part, Dual<B, n>>
    : std::integral_constant<bool, !Part::explicit_step && (n == 6 || !Part::couples)> {};

template <class Part, class T>
RACEWAY_INLINE void act_if(unsigned parts, const RacewayPhysics &p,
                           const RacewayConstantsT<Value<T>> &k, LawStates<T> &m,
                           ContactStateT<T> &c)
{
  if constexpr (Takes<Part, T>::value)
    if (parts & Parts::bit<Part>()) {
      call_act<Part>(p, k, m, c);
      m.before += Part::states;
      m.after += Part::states;
    }
}
template <class T, class... P>
RACEWAY_CALLED void act_one_by_one(unsigned parts, const RacewayPhysics &p,
                                   const RacewayConstantsT<Value<T>> &k, LawStates<T> m,
                                   ContactStateT<T> &c)
{
  begin_law<true>(c);
  (act_if<P>(parts, p, k, m, c), ...);
}

template <class Part, class T, class Mask>
RACEWAY_CALLED void call_misses(const RacewayPhysics &p, const RacewayConstantsT<T> &k,
                                ContactStateT<T> &c, Mask &some)
{
  if constexpr (detail::Decides<Part>::value) some = some | Part::misses(p.of<Part>(), p, k, c);
}
template <class T, class Mask, class... P>
RACEWAY_CALLED void any_misses(unsigned parts, const RacewayPhysics &p,
                               const RacewayConstantsT<T> &k, ContactStateT<T> &c, Mask &some)
{
  some = c.overlap < -p.reach;
  ((parts & Parts::bit<P>() && detail::Decides<P>::value ? call_misses<P>(p, k, c, some) : void()),
   ...);
}

template <class Part, class T>
RACEWAY_INLINE void beyond_if(unsigned parts, const RacewayPhysics &p, const ContactStateT<T> &c,
                              T &result)
{
  if constexpr (detail::Decides<Part>::value)
    if (parts & Parts::bit<Part>()) result = Part::beyond(p.of<Part>(), c);
}
template <class T, class... P>
RACEWAY_CALLED void any_beyond(unsigned parts, const RacewayPhysics &p, const ContactStateT<T> &c,
                               T &result)
{
  result = c.overlap;
  (beyond_if<P>(parts, p, c, result), ...);
}

template <class Part, class T>
RACEWAY_CALLED void add_energy(const RacewayPhysics &p, const ContactStateT<T> &c, T &sum)
{
  sum += Part::energy(p.of<Part>(), p, c);
}
template <class T, class... P>
RACEWAY_CALLED void any_energy(unsigned parts, const RacewayPhysics &p, const ContactStateT<T> &c,
                               T &sum)
{
  sum = T();
  ((parts & Parts::bit<P>() ? add_energy<P>(p, c, sum) : void()), ...);
}

template <class Part, class T> RACEWAY_CALLED void add_loss(const ContactStateT<T> &c, T &sum)
{
  sum += Part::Losses::of(c);
}
template <class T, class... P>
RACEWAY_CALLED void any_loss(unsigned parts, const ContactStateT<T> &c, T &sum)
{
  sum = T();
  ((parts & Parts::bit<P>() ? add_loss<P>(c, sum) : void()), ...);
}

template <class... P> constexpr LawFunctions law_functions(PartList<P...>)
{
  return {act_one_by_one<Lane, P...>,
          act_one_by_one<Dual<Lane, 3>, P...>,
          act_one_by_one<Dual<Lane, 6>, P...>,
          any_misses<Lane, LaneMask, P...>,
          any_beyond<Lane, P...>,
          any_energy<Lane, P...>,
          any_loss<Lane, P...>};
}

}    // namespace
}    // namespace raceway

#undef RACEWAY_CALLED
