// SPDX-License-Identifier: GPL-2.0-or-later
// A contact law as a compile-time list of parts (part.h), each in a file of its own: what a scene
// does not ask for is not in its list and costs nothing.
#ifndef RACEWAY_LAW_H
#define RACEWAY_LAW_H

#include "part.h"

#include <tuple>

namespace raceway {

// All parts there are; a set of them is a word of bits, in the order of the list.
template <class... P> struct PartList {
  using Parameters = std::tuple<typename P::Parameters...>;
  static constexpr int size = sizeof...(P);

  template <class Part> static constexpr int place()
  {
    const bool same[] = {std::is_same<P, Part>::value...};
    for (int k = 0; k < size; ++k)
      if (same[k]) return k;
    return -1;
  }
  template <class Part> static constexpr unsigned bit() { return 1u << place<Part>(); }

  template <class Part> struct Tag {
    using type = Part;
  };
  template <class F> static void each(const F &f) { (f(Tag<P>()), ...); }    // type of its argument
};

namespace detail {
template <class Part, class = void> struct Decides : std::false_type {};
template <class Part>
struct Decides<
    Part, std::void_t<decltype(Part::misses(
              std::declval<const typename Part::Parameters &>(), std::declval<const Raceway &>(),
              std::declval<const RacewayConstants &>(), std::declval<ContactState &>()))>>
    : std::true_type {};
}    // namespace detail

// A law: its parts act in this order. All is the list of all parts.
template <class All, class... P> struct LawOf {
  static constexpr unsigned parts = (All::template bit<P>() | ...);
  static constexpr int states = (P::states + ...);
  static constexpr bool couples = (P::couples || ...);
  static constexpr bool explicit_step = (P::explicit_step || ...);
  static constexpr int motions = couples ? 6 : 3;    // that forces depend on

  // Everything that the law makes of the motions in c. Physics gives each part its own numbers.
  template <class Physics, class T>
  static RACEWAY_INLINE void act(const Physics &p, const RacewayConstantsT<Value<T>> &k,
                                 LawStates<T> m, ContactStateT<T> &c)
  {
    c.compression = c.overlap;
    c.friction_t = c.friction_w = T();
    if constexpr (couples) {
      c.couple_n = c.couple_t = c.couple_w = T();
      c.slip_couple = c.rolling_couple = c.hysteresis_couple = c.drag = Value<T>();
    }
    (one<P>(p, k, m, c), ...);
  }

  // Whether there is no contact, although the overlap is above -reach: a part may know.
  static constexpr bool decides = (detail::Decides<P>::value || ...);
  template <class Physics, class T>
  static RACEWAY_INLINE auto misses(const Physics &p, const RacewayConstantsT<T> &k,
                                    ContactStateT<T> &c)
  {
    auto some = c.overlap < -p.reach;
    (ask<P>(p, k, c, some), ...);
    return some;
  }

  // m, overlap past the place where the load begins, by the part that knows
  template <class Physics, class T>
  static RACEWAY_INLINE T beyond(const Physics &p, const ContactStateT<T> &c)
  {
    T result = c.overlap;
    (measure<P>(p, c, result), ...);
    return result;
  }

  // J, stored
  template <class Physics, class T>
  static RACEWAY_INLINE Value<T> energy(const Physics &p, const ContactStateT<T> &c)
  {
    Value<T> sum = Value<T>();
    ((sum += P::energy(p.template of<P>(), p, c)), ...);
    return sum;
  }

  // W, lost to damping, friction and whatever else a part takes
  template <class T> static RACEWAY_INLINE Value<T> loss(const ContactStateT<T> &c)
  {
    Value<T> sum = Value<T>();
    ((sum += P::Losses::of(c)), ...);
    return sum;
  }

 private:
  template <class Part, class Physics, class T, class Mask>
  static RACEWAY_INLINE void ask(const Physics &p, const RacewayConstantsT<T> &k,
                                 ContactStateT<T> &c, Mask &some)
  {
    if constexpr (detail::Decides<Part>::value)
      some = some | Part::misses(p.template of<Part>(), p, k, c);
  }
  template <class Part, class Physics, class T>
  static RACEWAY_INLINE void measure(const Physics &p, const ContactStateT<T> &c, T &beyond)
  {
    if constexpr (detail::Decides<Part>::value) beyond = Part::beyond(p.template of<Part>(), c);
  }
  template <class Part, class Physics, class T>
  static RACEWAY_INLINE void one(const Physics &p, const RacewayConstantsT<Value<T>> &k,
                                 LawStates<T> &m, ContactStateT<T> &c)
  {
    Part::act(p.template of<Part>(), p, k, m, c);
    if constexpr (Part::states > 0) {
      m.before += Part::states;
      m.after += Part::states;
    }
  }
};

}    // namespace raceway

#endif
