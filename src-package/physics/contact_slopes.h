// SPDX-License-Identifier: GPL-2.0-or-later
// A law together with its derivative in the local motions of the contact: what an implicit step
// solves with. The law is evaluated once, in duals (dual.h); nothing of a law is written here.
//
// Motions: approach of ball and raceway, sliding along t and w; if the law has couples, also the
// relative rotation about n, t and w. Forces: N, f_t, f_w; couples about n, t, w. Over a time in
// which positions follow velocities the overlap follows the approach.
#ifndef RACEWAY_CONTACT_SLOPES_H
#define RACEWAY_CONTACT_SLOPES_H

#include "contact.h"

namespace raceway {

template <class T, int n> struct ContactSlopesT {
  T of[n][n];                                       // of[i][k]: force i over motion k
  T state[most_states > 0 ? most_states : 1][n];    // what the contact keeps, over motion k
};

// As L::act(); c is what it was before but for what the law sets. `follows` (s): how long the
// overlap follows the approach, the length of an implicit stage, 0 where positions are given.
template <class L, class B>
RACEWAY_INLINE void act_with_slopes(const RacewayPhysics &p, const LawStates<B> &memory,
                                    double follows, ContactStateT<B> &c,
                                    ContactSlopesT<B, L::motions> &slopes)
{
  constexpr int n = L::motions;
  using D = Dual<B, n>;
  const B one = B() + 1.0;
  ContactStateT<D> x;
  static_cast<GroovePositionT<B> &>(x) = c;
  x.cos_angle = c.cos_angle;
  x.entrainment = c.entrainment;
  x.h_edge = c.h_edge;
  x.ln_speed = c.ln_speed;
  x.film_factor = c.film_factor;
  x.overlap = c.overlap;
  x.overlap.d[0] = B() + follows;
  x.overlap_rate = c.overlap_rate;
  x.overlap_rate.d[0] = one;
  x.sliding_t = c.sliding_t;
  x.sliding_t.d[1] = one;
  x.sliding_w = c.sliding_w;
  x.sliding_w.d[2] = one;
  if constexpr (L::couples) {
    x.spin_n = c.spin_n;
    x.spin_n.d[3] = one;
    x.turn_t = c.turn_t;
    x.turn_t.d[4] = one;
    x.roll_w = c.roll_w;
    x.roll_w.d[5] = one;
  }
  D after[L::states > 0 ? L::states : 1];
  L::act(p, p.law.at(c.cos_angle), LawStates<D>{memory.dt, memory.before, after, memory.stage}, x);
  for (int k = 0; k < L::states; ++k) {
    memory.after[k] = held(after[k]);
    for (int i = 0; i < n; ++i) slopes.state[k][i] = after[k].d[i];
  }

  c.compression = held(x.compression);
  c.root = held(x.root);
  c.load = held(x.load);
  c.stiffness = x.stiffness;
  c.damping = x.damping;
  c.normal = held(x.normal);
  c.film_load = x.film_load;
  c.ln_speed = x.ln_speed;
  c.ln_film_load = x.ln_film_load;
  c.film_factor = x.film_factor;
  c.h_c = x.h_c;
  c.h_min = x.h_min;
  c.lambda = x.lambda;
  c.film_energy = x.film_energy;
  c.film_force = x.film_force;
  c.film_stiffness = x.film_stiffness;
  c.film_rate = x.film_rate;
  c.branch_energy = x.branch_energy;
  c.mu = x.mu;
  c.asperity_share = x.asperity_share;
  c.kt = x.kt;
  c.ct = held(x.ct);
  c.v_0 = x.v_0;
  c.friction_t = held(x.friction_t);
  c.friction_w = held(x.friction_w);
  const D *forces[] = {&x.normal,   &x.friction_t, &x.friction_w,
                       &x.couple_n, &x.couple_t,   &x.couple_w};
  if constexpr (L::couples) {
    c.slip_couple = x.slip_couple;
    c.rolling_couple = x.rolling_couple;
    c.hysteresis_couple = x.hysteresis_couple;
    c.drag = x.drag;
    c.drag_power = x.drag_power;
    c.couple_n = held(x.couple_n);
    c.couple_t = held(x.couple_t);
    c.couple_w = held(x.couple_w);
  }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) slopes.of[i][k] = forces[i]->d[k];
}

}    // namespace raceway

#endif
