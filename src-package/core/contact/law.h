// SPDX-License-Identifier: GPL-2.0-or-later
// A contact law as a compile-time list of parts (part.h), each defined in a file of its own. Parts
// that a scene does not use are not in its list and cost nothing.
#pragma once

#include "../parts/part.h"
#include "../raceway/raceway_physics.h"

#include <tuple>

namespace raceway {

namespace detail {
constexpr bool same_text(const char *a, const char *b)
{
  while (*a && *a == *b) ++a, ++b;
  return *a == *b;
}
}    // namespace detail

// List of all available parts. A set of parts is represented by a bit mask in the order of the
// list.
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
  template <class... Some> static constexpr bool in_order()
  {
    int last = -1;
    return ((last < place<Some>() && (last = place<Some>(), true)) && ...);
  }
  static constexpr unsigned in_slot(const char *slot)
  {
    return ((detail::same_text(P::slot, slot) ? bit<P>() : 0u) | ...);
  }
  // Largest number of state variables per contact for any set of parts; parts with the same slot
  // exclude each other.
  static constexpr int most_states()
  {
    const int states[] = {P::states...};
    const char *const slots[] = {P::slot...};
    int sum = 0;
    for (int k = 0; k < size; ++k) {
      bool most = true;
      for (int i = 0; slots[k][0] && i < size; ++i)
        if (detail::same_text(slots[i], slots[k]))
          most &= states[i] < states[k] || (states[i] == states[k] && i >= k);
      if (most) sum += states[k];
    }
    return sum;
  }

  template <class Part> struct Tag {
    using type = Part;
  };
  template <class F> static void each(const F &f) { (f(Tag<P>()), ...); }    // F takes Tag<P>
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

// Sets the initial values that every law needs, regardless of its parts.
template <bool couples, class T> RACEWAY_INLINE void begin_law(ContactStateT<T> &c)
{
  c.compression = c.overlap;
  c.friction_t = c.friction_w = T();
  if constexpr (couples) {
    c.couple_n = c.couple_t = c.couple_w = T();
    c.slip_couple = c.rolling_couple = c.hysteresis_couple = c.drag = Value<T>();
  }
}

// A law, whose parts act in this order. All is the list of all parts. The class in any_law.h has
// the same members for a set of parts.
template <class All, class... P> struct LawOf {
  static constexpr unsigned parts = (All::template bit<P>() | ...);
  static_assert(All::template in_order<P...>(), "parts act in the order of the list of all parts");
  static constexpr int states = (P::states + ...);
  static constexpr int room = states > 0 ? states : 1;    // length of the array of state variables
  static constexpr bool couples = (P::couples || ...);
  static constexpr bool explicit_step = (P::explicit_step || ...);
  static constexpr int motions = couples ? 6 : 3;    // number of motions on which forces depend
  static constexpr bool decides = (detail::Decides<P>::value || ...);
  static constexpr bool takes_profiles = false;    // the law is compiled for smooth raceways only

  // Evaluates all parts for the motions in c.
  template <class T>
  static RACEWAY_INLINE void act(const RacewayPhysics &p, const RacewayConstantsT<Value<T>> &k,
                                 LawStates<T> m, ContactStateT<T> &c)
  {
    begin_law<couples>(c);
    (one<P>(p, k, m, c), ...);
  }

  // Returns true if a part decides that there is no contact although the overlap exceeds -reach.
  template <class T>
  static RACEWAY_INLINE auto misses(const RacewayPhysics &p, const RacewayConstantsT<T> &k,
                                    ContactStateT<T> &c)
  {
    auto some = c.overlap < -p.reach;
    (ask<P>(p, k, c, some), ...);
    return some;
  }

  // Returns the overlap beyond the onset of the load, m, from the part that defines the onset.
  template <class T>
  static RACEWAY_INLINE T beyond(const RacewayPhysics &p, const ContactStateT<T> &c)
  {
    T result = c.overlap;
    (measure<P>(p, c, result), ...);
    return result;
  }

  // Returns the stored energy, J.
  template <class T>
  static RACEWAY_INLINE Value<T> energy(const RacewayPhysics &p, const ContactStateT<T> &c)
  {
    Value<T> sum = Value<T>();
    ((sum += P::energy(p.of<P>(), p, c)), ...);
    return sum;
  }

  // Returns the power dissipated by damping, friction and all other parts, W.
  template <class T> static RACEWAY_INLINE Value<T> loss(const ContactStateT<T> &c)
  {
    Value<T> sum = Value<T>();
    ((sum += P::Losses::of(c)), ...);
    return sum;
  }

 private:
  template <class Part, class T, class Mask>
  static RACEWAY_INLINE void ask(const RacewayPhysics &p, const RacewayConstantsT<T> &k,
                                 ContactStateT<T> &c, Mask &some)
  {
    if constexpr (detail::Decides<Part>::value) some = some | Part::misses(p.of<Part>(), p, k, c);
  }
  template <class Part, class T>
  static RACEWAY_INLINE void measure(const RacewayPhysics &p, const ContactStateT<T> &c, T &beyond)
  {
    if constexpr (detail::Decides<Part>::value) beyond = Part::beyond(p.of<Part>(), c);
  }
  template <class Part, class T>
  static RACEWAY_INLINE void one(const RacewayPhysics &p, const RacewayConstantsT<Value<T>> &k,
                                 LawStates<T> &m, ContactStateT<T> &c)
  {
    Part::act(p.of<Part>(), p, k, m, c);
    if constexpr (Part::states > 0) {
      m.before += Part::states;
      m.after += Part::states;
    }
  }
};

}    // namespace raceway
