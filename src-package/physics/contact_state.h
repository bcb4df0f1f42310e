// SPDX-License-Identifier: GPL-2.0-or-later
// What a contact is at one instant: motions, and what the parts of the law make of them.
//
// T is double, Lane, or a Dual of one of them; what no derivative follows is of T's plain type.
// Frame of groove.h: n from ball to raceway, t along rolling, w = n x t across. Units are SI.
#ifndef RACEWAY_CONTACT_STATE_H
#define RACEWAY_CONTACT_STATE_H

#include "dual.h"
#include "groove.h"

namespace raceway {

template <class T> struct ContactStateT : GroovePositionT<Value<T>> {
  using Plain = Value<T>;
  // motions of the ball against the raceway (kinematics.h)
  T overlap = T();        // m, of the rigid surfaces; negative for a gap
  T compression = T();    // m, what the elastic bodies give way: the overlap and what parts add
  Plain cos_angle = Plain();                     // of the contact angle
  T overlap_rate = T();                          // m/s
  Plain entrainment = Plain();                   // m/s
  T sliding_t = T(), sliding_w = T();            // m/s, ball surface minus ring surface
  T spin_n = T(), turn_t = T(), roll_w = T();    // rad/s, ball minus ring; if the law has couples
  // what parts leave for one another and for output
  T root = T();                 // sqrt(m), of the compression
  T load = T();                 // N, Q, elastic
  Plain stiffness = Plain();    // N/m, dQ/d(overlap)
  Plain damping = Plain();      // N s/m, C
  T normal = T();               // N, max(0, Q + C d(overlap)/dt)
  Plain film_load = Plain();    // N, at which the film is taken
  // logarithms of the entrainment speed (m/s) and of film_load; the factors of the film
  Plain ln_speed = Plain(), ln_film_load = Plain(), film_factor = Plain();
  Plain h_edge = Plain(), h_c = Plain();      // m, central film, where it begins and here
  Plain h_min = Plain(), lambda = Plain();    // m; film parameter
  Plain film_energy = Plain();                // J, of the film in the gap
  Plain film_force = Plain();                 // N, of the film's branch
  Plain film_stiffness = Plain();             // N/m, of the film's branch
  Plain film_rate = Plain();                  // 1/s, 1/tau of the film's branch
  Plain branch_energy = Plain();              // J, of the film's branch
  Plain mu = Plain();                         // friction coefficient
  Plain kt = Plain();                         // N/m, tangential spring
  T ct = T();                                 // N s/m, tangential dashpot
  Plain v_0 = Plain();                        // m/s, of the smoothed Coulomb law
  Plain slip_width = Plain();                 // m/s, of the differential slip
  // the force of the ring on the ball is -normal n - friction_t t - friction_w w
  T friction_t = T(), friction_w = T();    // N
  // the couple of the ring on the ball is -couple_n n - couple_t t - couple_w w
  T couple_n = T(), couple_t = T(), couple_w = T();    // N m
  Plain asperity_share = Plain();                      // of the load
  // parts of couple_w, N m
  Plain slip_couple = Plain(), rolling_couple = Plain(), hysteresis_couple = Plain();
  // of the oil on the ball's centre, -drag t, if the law has couples; its power
  Plain drag = Plain(), drag_power = Plain();    // N, W
};
using ContactState = ContactStateT<double>;

}    // namespace raceway

#endif
