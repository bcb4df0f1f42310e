// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluates a contact law and its derivatives with respect to the local motions of the contact, for
// the implicit step. The law is evaluated once, in dual numbers (dual.h); this file does not depend
// on the law.
//
// The motions are the approach of ball and raceway, the sliding along t and w and, if the law has
// couples, the relative rotations about n, t and w. The forces are N, f_t, f_w and, if the law has
// couples, the couples about n, t, w. The overlap changes with the approach for as long as
// positions change with velocities.
#pragma once

#include "../parts/part.h"
#include "../raceway/raceway_physics.h"

namespace raceway {

template <class T, int n> struct alignas(sizeof(Value<T>)) ContactSlopesT {
  T of[n][n];                 // of[i][k]: derivative of force i with respect to motion k
  T state[most_states][n];    // state[j][k]: derivative of state variable j
};

// Works like law.act(); the only values of c that change are those set by the law. `follows` (s) is
// the time over which the overlap follows the approach, i.e. the length of an implicit stage, or 0
// if positions are given.
template <class L, class B>
RACEWAY_INLINE void act_with_slopes(const L &law, const RacewayPhysics &p,
                                    const LawStates<B> &memory, double follows, ContactStateT<B> &c,
                                    ContactSlopesT<B, L::motions> &slopes)
{
  constexpr int n = L::motions;
  using D = Dual<B, n>;
  const B one = B() + 1.0;
  ContactStateT<D> x;
  copy_state(c, x);
  x.overlap.d[0] = B() + follows;
  x.overlap_rate.d[0] = one;
  x.sliding_t.d[1] = one;
  x.sliding_w.d[2] = one;
  if constexpr (L::couples) {
    x.spin_n.d[3] = one;
    x.turn_t.d[4] = one;
    x.roll_w.d[5] = one;
  }
  D after[L::room];
  law.act(p, p.law.at(c.cos_angle), LawStates<D>{memory.dt, memory.before, after, memory.stage}, x);
  for (int k = 0; k < law.states; ++k) {
    memory.after[k] = held(after[k]);
    for (int i = 0; i < n; ++i) slopes.state[k][i] = after[k].d[i];
  }
  copy_state(x, c);
  const D *forces[] = {&x.normal,   &x.friction_t, &x.friction_w,
                       &x.couple_n, &x.couple_t,   &x.couple_w};
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) slopes.of[i][k] = forces[i]->d[k];
}

}    // namespace raceway
