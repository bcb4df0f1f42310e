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
}    // namespace detail

inline bool alike(const BearingModel &a, const BearingModel &b)
{
  using M = BearingModel;
  return a.parts == b.parts &&
         detail::all_alike(a.bodies, b.bodies,
                           [](const M::Body &x, const M::Body &y) {
                             return x.mass == y.mass && x.radius == y.radius && x.spins == y.spins;
                           }) &&
         detail::all_alike(a.rings, b.rings,
                           [](const M::Ring &x, const M::Ring &y) {
                             return x.mover == y.mover && x.on_shaft == y.on_shaft &&
                                    x.at == y.at && x.holder == y.holder &&
                                    detail::all_alike(x.own, y.own,
                                                      [](const RingValue &v, const RingValue &w) {
                                                        return v.which == w.which;
                                                      });
                           }) &&
         detail::all_alike(a.shafts, b.shafts,
                           [](const M::Shaft &x, const M::Shaft &y) {
                             return x.mover == y.mover && x.rings == y.rings;
                           }) &&
         detail::all_alike(a.grooves, b.grooves,
                           [](const M::Groove &x, const M::Groove &y) {
                             return x.body == y.body && x.ring == y.ring &&
                                    x.physics == y.physics && x.profile == y.profile &&
                                    x.ball == y.ball;
                           }) &&
         detail::all_alike(a.pockets, b.pockets,
                           [](const M::Pocket &x, const M::Pocket &y) {
                             return x.a == y.a && x.b == y.b && x.K == y.K && x.reach == y.reach &&
                                    x.mass == y.mass;
                           }) &&
         detail::all_alike(a.seats, b.seats,
                           [](const M::Seat &x, const M::Seat &y) {
                             return x.body == y.body && x.ring == y.ring && x.rails == y.rails &&
                                    x.stiffness == y.stiffness;
                           }) &&
         detail::all_alike(a.cages, b.cages, [](const M::Cage &x, const M::Cage &y) {
           return x.ring == y.ring && x.land == y.land && x.of == y.of && x.balls == y.balls;
         });
}

}    // namespace raceway
