// SPDX-License-Identifier: GPL-2.0-or-later
// One ball on one raceway: from positions and velocities to load, film, friction, force and torque.
//
// The contact point is R_b along the normal from the ball centre; both bodies are taken rigid
// there. The force of the raceway on the ball is -N n - f_t t - f_w w (frame of groove.h), its
// opposite acts on the ring at the same point, so linear and angular momentum are conserved to
// rounding.
//
// Entrainment speed (docs/theory, Film): half the sum of both surface velocities relative to the
// moving contact point, along t. The contact point rc u + zc e turns about the ring axis with the
// ball centre, at phi' = ((v_b - v_r).t + z W.u)/r, and tilts with the axis: u'.t = phi', e'.t =
// -W.u.
#ifndef RACEWAY_CONTACT_H
#define RACEWAY_CONTACT_H

#include "friction.h"
#include "raceway_law.h"

namespace raceway {

enum class Friction { none, constant, stribeck };

// Everything about one raceway that does not change during a run.
struct RacewayPhysics {
  Groove groove;
  RacewayMaterial material;
  RacewayModel model;
  Friction friction = Friction::none;
  double mu = 0.0;                   // Friction::constant
  StribeckCurve curve;               // Friction::stribeck and regimes
  double hysteresis = 0.08;          // s/m, alpha_e
  double ring_roughness = 0.0;       // m
  double ball_roughness = 0.0;       // m
  double film_floor = -1.0;          // m, of the film damper; < 0: composite roughness
  double tangential_ratio = -1.0;    // k_t/k_n; < 0: Mindlin
  double tangential_zeta = 0.3;      // dashpot over critical of the rolling mode, mass 2/7 m_b
  double creep = 0.0;    // > 0: smoothed Coulomb law, v_0 = creep * entrainment speed; 0: spring
  double creep_floor = 1e-4;    // m/s, least v_0: a bearing at rest

  // derived by prepare()
  RacewayLaw law;
  double centre_circle = 0.0, slack = 0.0, largest_overlap = 0.0;
  double roughness = 0.0, inverse_roughness = 0.0, floor = 0.0;
  double kt_ratio = 0.0, ct_factor = 0.0;

  // pitch_radius (m) sets gamma; ball_mass (kg) the dashpot; overlap_limit is a fraction of R_b.
  void prepare(double pitch_radius, double ball_mass, double overlap_limit)
  {
    law = RacewayLaw(groove, pitch_radius, material, model);
    centre_circle = groove.centre_circle();
    slack = groove.slack();
    largest_overlap = overlap_limit * groove.ball_radius;
    roughness = composite_roughness(ring_roughness, ball_roughness);
    inverse_roughness = roughness > 0.0 ? 1.0 / roughness : 0.0;
    floor = film_floor >= 0.0 ? film_floor : roughness;
    kt_ratio = tangential_ratio >= 0.0
                   ? tangential_ratio
                   : raceway::tangential_ratio(material.ball_young, material.ball_poisson,
                                               material.ring_young, material.ring_poisson);
    ct_factor = 2.0 * tangential_zeta * std::sqrt(2.0 / 7.0 * ball_mass);
  }
};

template <class T> struct BallStateT {
  Vec3T<T> x, v, w;
};
using BallState = BallStateT<double>;

template <class T> struct RingStateT {
  Vec3T<T> x, v, w;
  Vec3T<T> e;    // unit axis
};
using RingState = RingStateT<double>;

// What a contact is at one instant. Speeds m/s, forces N, lengths m.
template <class T> struct ContactStateT : GroovePositionT<T> {    // u, t, r, z, s, nu, ne
  T overlap = T(), root = T();                                    // overlap and its square root
  T cos_angle = T();                                              // of the contact angle
  T overlap_rate = T();
  T load = T();         // Q, elastic
  T stiffness = T();    // dQ/d(overlap), N/m
  T damping = T();      // C, N s/m
  T normal = T();       // N = max(0, Q + C d(overlap)/dt)
  T entrainment = T();
  T sliding_t = T(), sliding_w = T();    // ball surface minus ring surface
  T h_min = T(), lambda = T();
  T mu = T();
  T kt = T(), ct = T();                    // tangential spring and dashpot
  T v_0 = T();                             // m/s, of the smoothed Coulomb law
  T friction_t = T(), friction_w = T();    // force of the ring on the ball is -friction
};
using ContactState = ContactStateT<double>;

template <class T> struct ContactForcesT {
  Vec3T<T> force;          // on the ball
  Vec3T<T> ball_torque;    // about the ball centre
  Vec3T<T> ring_torque;    // about the ring centre
};
using ContactForces = ContactForcesT<double>;

// Geometry only. True where the surfaces overlap (or a position is not a number); only then the
// frame is set.
inline bool touch(const RacewayPhysics &p, const Vec3 &d, const Vec3 &e, ContactState &c)
{
  if (!locate_beyond(d, e, p.centre_circle, p.slack, c)) return false;
  c.overlap = c.s - p.slack;
  return !(c.overlap <= 0.0);
}

// Friction by a spring with history xi (2 values, m), advanced over dt; dt = 0 leaves it as it is.
struct FrictionSpring {
  double dt, *xi;
  void operator()(const RacewayPhysics &p, ContactState &c) const
  {
    c.kt = p.kt_ratio * c.stiffness;
    c.ct = p.ct_factor * std::sqrt(c.kt);
    xi[0] += dt * c.sliding_t;
    xi[1] += dt * c.sliding_w;
    tangential_force({c.kt, c.ct}, c.mu * c.normal, c.sliding_t, c.sliding_w, xi, c.friction_t,
                     c.friction_w);
  }
};

// Friction by Coulomb's law smoothed over a creep speed; needs p.creep > 0.
struct FrictionSmoothed {
  template <class T>
  RACEWAY_INLINE void operator()(const RacewayPhysics &p, ContactStateT<T> &c) const
  {
    const T u = p.creep * c.entrainment;
    c.v_0 = square_root(u * u + p.creep_floor * p.creep_floor);
    c.kt = T();
    c.ct = smoothed_friction(T(c.mu * c.normal), c.sliding_t, c.sliding_w, c.v_0);
    c.friction_t = c.ct * c.sliding_t;
    c.friction_w = c.ct * c.sliding_w;
  }
};

// Loads, film and friction of a contact whose overlap is set and positive; `tangential` is one of
// the two above.
template <bool with_film, Friction friction, class T, class Tangential>
RACEWAY_INLINE ContactForcesT<T> contact_forces(const RacewayPhysics &p, const BallStateT<T> &ball,
                                                const RingStateT<T> &ring,
                                                const Tangential &tangential, ContactStateT<T> &c)
{
  const double Rb = p.groove.ball_radius;
  c.root = square_root(c.overlap);
  c.cos_angle = magnitude(c.nu);
  const RacewayConstantsT<T> k = p.law.at(c.cos_angle);

  // velocities in (u, t, e), relative to the ring centre
  const Vec3T<T> dv = ball.v - ring.v;
  const T vu = dot(dv, c.u), vt = dot(dv, c.t), ve = dot(dv, ring.e);
  const T wu = dot(ball.w, c.u), wt = dot(ball.w, c.t), we = dot(ball.w, ring.e);
  const T Wu = dot(ring.w, c.u), Wt = dot(ring.w, c.t), We = dot(ring.w, ring.e);
  const T rc = c.r + Rb * c.nu, zc = c.z + Rb * c.ne;             // contact point in the ring
  const T Vu = Wt * zc, Vt = We * rc - Wu * zc, Ve = -Wt * rc;    // ring surface, W x (rc u + zc e)

  c.overlap_rate = (vu - Vu) * c.nu + (ve - Ve) * c.ne;
  const T roll = Rb * (we * c.nu - wu * c.ne);    // ball surface along t, from its spin
  c.sliding_t = vt + roll - Vt;
  c.sliding_w = (ve - Ve) * c.nu - (vu - Vu) * c.ne - Rb * wt;
  const T turn = (vt + c.z * Wu) / c.r * rc - Wu * zc;    // contact point along t
  c.entrainment = 0.5 * magnitude(T((vt + roll - turn) + (Vt - turn)));

  c.load = k.K * c.overlap * c.root;
  c.stiffness = 1.5 * k.K * c.root;
  c.damping = hysteretic_damping(p.hysteresis, c.load);
  if (with_film) {
    c.h_min = film_thickness(k.film.min, film_point(c.entrainment, c.load));
    c.lambda = c.h_min * p.inverse_roughness;
    c.damping += film_damping(k.film_damper, T(k.a * c.root), c.h_min, p.floor);
  }
  const T N = c.load + c.damping * c.overlap_rate;
  c.normal = where(N > 0.0, N, 0.0);

  c.friction_t = c.friction_w = T();
  if (friction != Friction::none) {
    c.mu = friction == Friction::stribeck ? stribeck(p.curve, c.lambda) : T() + p.mu;
    tangential(p, c);
  }

  // w = n x t = nu e - ne u; lever of the ball Rb n, of the ring rc u + zc e
  const T ft = c.friction_t, fw = c.friction_w;
  const T fu = -c.normal * c.nu + fw * c.ne, fe = -c.normal * c.ne - fw * c.nu;
  ContactForcesT<T> f;
  f.force = c.u * fu + c.t * T(-ft) + ring.e * fe;
  // n x t = w, n x w = -t
  f.ball_torque = c.u * T(Rb * ft * c.ne) + ring.e * T(-Rb * ft * c.nu) + c.t * T(Rb * fw);
  // -(rc u + zc e) x F with u x t = e, t x e = u, e x u = t
  f.ring_torque = c.u * T(-zc * ft) + c.t * T(rc * fe - zc * fu) + ring.e * T(rc * ft);
  return f;
}

}    // namespace raceway

#endif
