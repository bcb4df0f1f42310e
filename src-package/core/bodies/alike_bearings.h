// SPDX-License-Identifier: GPL-2.0-or-later
// Bearings that share one solver and use it one after another. Such bearings differ only in the
// tags of their atoms and in the values that are set for individual rings, which are loaded
// together with the state.
#pragma once

#include "bearing_model.h"

#include <algorithm>

namespace raceway {

namespace detail {
template <class List, class Test> bool all_alike(const List &a, const List &b, const Test &test)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), test);
}

// Returns a test whether these members of two objects are equal.
template <class Class, class... Member> auto equal_in(Member Class::*...member)
{
  return [=](const Class &x, const Class &y) { return ((x.*member == y.*member) && ...); };
}
}    // namespace detail

inline bool alike(const BearingModel &a, const BearingModel &b)
{
  using M = BearingModel;
  using namespace detail;
  const auto rings = equal_in(&M::Ring::mover, &M::Ring::on_shaft, &M::Ring::at, &M::Ring::holder);
  const auto pockets =
      equal_in(&M::Pocket::a, &M::Pocket::b, &M::Pocket::K, &M::Pocket::reach, &M::Pocket::mass);
  return a.parts == b.parts &&
         all_alike(a.bodies, b.bodies,
                   equal_in(&M::Body::mass, &M::Body::radius, &M::Body::spins)) &&
         all_alike(a.rings, b.rings,
                   [&](const M::Ring &x, const M::Ring &y) {
                     return rings(x, y) && all_alike(x.own, y.own, equal_in(&RingValue::which));
                   }) &&
         all_alike(a.shafts, b.shafts, equal_in(&M::Shaft::mover, &M::Shaft::rings)) &&
         all_alike(a.grooves, b.grooves,
                   equal_in(&M::Groove::body, &M::Groove::ring, &M::Groove::physics,
                            &M::Groove::profile, &M::Groove::ball)) &&
         all_alike(a.pockets, b.pockets, pockets) &&
         all_alike(
             a.seats, b.seats,
             equal_in(&M::Seat::body, &M::Seat::ring, &M::Seat::rails, &M::Seat::stiffness)) &&
         all_alike(a.cages, b.cages,
                   equal_in(&M::Cage::ring, &M::Cage::land, &M::Cage::of, &M::Cage::balls));
}

}    // namespace raceway
