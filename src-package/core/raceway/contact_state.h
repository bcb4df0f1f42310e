// SPDX-License-Identifier: GPL-2.0-or-later
// State of a contact at one instant: the motion of the bodies, and the results of the parts of the
// law.
//
// T is double, Lane, or a Dual of either type; quantities without derivatives have the plain type
// of T. The frame is that of groove.h: n from ball to raceway, t along rolling, w = n x t across.
// Units are SI.
#pragma once

#include "../geometry/groove.h"
#include "../numbers/dual.h"

#include <utility>

namespace raceway {

// Quantities that carry derivatives.
template <class T> struct alignas(sizeof(Value<T>)) ContactVariablesT {
  // motions of the ball relative to the raceway (kinematics.h)
  T overlap = T();         // m, overlap of the rigid surfaces; negative for a gap
  T compression = T();     // m, elastic approach of the bodies, i.e. the overlap plus the
                           // contributions of parts
  T overlap_rate = T();    // m/s
  T sliding_t = T(), sliding_w = T();            // m/s, velocity of the ball surface relative to
                                                 // the ring surface
  T spin_n = T(), turn_t = T(), roll_w = T();    // rad/s, of the ball relative to the ring; used
                                                 // only if the law has couples
  // intermediate results for other parts and for output
  T root = T();      // sqrt(m), square root of the compression
  T load = T();      // N, elastic load Q
  T normal = T();    // N, max(0, Q + C d(overlap)/dt)
  T ct = T();        // N s/m, tangential dashpot
  // the force of the ring on the ball is -normal n - friction_t t - friction_w w
  T friction_t = T(), friction_w = T();    // N
  // the couple of the ring on the ball is -couple_n n - couple_t t - couple_w w
  T couple_n = T(), couple_t = T(), couple_w = T();    // N m
};

// Quantities that are treated as constant in derivatives.
template <class T> struct alignas(sizeof(T)) ContactFiguresT {
  T cos_angle = T();      // cosine of the contact angle
  T entrainment = T();    // m/s
  T stiffness = T();      // N/m, dQ/d(overlap)
  T damping = T();        // N s/m, C
  T film_load = T();      // N, load used for the film thickness
  // logarithms of the entrainment speed (m/s) and of film_load; the product of the film factors
  T ln_speed = T(), ln_film_load = T(), film_factor = T();
  T h_edge = T(), h_c = T();      // central film thickness at the onset of load and at the current
                                  // load, m
  T h_min = T(), lambda = T();    // m; lambda ratio
  T film_energy = T();            // J, energy of the film in the gap
  T film_force = T();             // N, force of the film's Maxwell branch
  T film_stiffness = T();         // N/m, stiffness of the film's branch
  T film_rate = T();              // 1/s, 1/tau for the film's branch
  T mu = T();                     // friction coefficient
  T kt = T();                     // N/m, tangential spring
  T v_0 = T();                    // m/s, creep speed of the smoothed Coulomb law
  T slip_width = T();             // m/s, width s_e of the differential slip
  T slip_curve = T();             // m, a^2/(2 R_d)
  T asperity_share = T();         // fraction of the load carried by asperities
  // contributions to couple_w, N m
  T slip_couple = T(), rolling_couple = T(), hysteresis_couple = T();
  // used only if the law has couples: oil drag, which exerts the force -drag t on the ball's
  // centre, and its power
  T drag = T(), drag_power = T();    // N, W
};

template <class T>
struct ContactStateT : GroovePositionT<Value<T>>,
                       ContactVariablesT<T>,
                       ContactFiguresT<Value<T>> {};
using ContactState = ContactStateT<double>;

namespace detail {
constexpr size_t n_variables = sizeof(ContactVariablesT<double>) / sizeof(double);

template <class A, class B, size_t... k>
RACEWAY_INLINE void copy_variables(const A *from, B *to, std::index_sequence<k...>)
{
  ((to[k] = held(from[k])), ...);
}
}    // namespace detail

// Copies the whole state to another number type. Derivatives are set to 0 or dropped.
template <class A, class B>
RACEWAY_INLINE void copy_state(const ContactStateT<A> &from, ContactStateT<B> &to)
{
  using P = Value<A>;
  using From = ContactVariablesT<A>;
  using To = ContactVariablesT<B>;
  static_assert(std::is_same<P, Value<B>>::value, "both have the same plain type");
  static_assert(sizeof(From) == detail::n_variables * sizeof(A), "nothing but numbers of type T");
  static_cast<GroovePositionT<P> &>(to) = from;
  static_cast<ContactFiguresT<P> &>(to) = from;
  detail::copy_variables(reinterpret_cast<const A *>(static_cast<const From *>(&from)),
                         reinterpret_cast<B *>(static_cast<To *>(&to)),
                         std::make_index_sequence<detail::n_variables>());
}

}    // namespace raceway
