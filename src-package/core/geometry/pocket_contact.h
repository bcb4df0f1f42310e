// SPDX-License-Identifier: GPL-2.0-or-later
// Forces between a ball and its pocket in a one-piece cage (cage_ring.h). Both integrators use the
// same model.
//
// The oil in the pocket resists the relative motion (pocket_film.h) and the relative spin of ball
// and cage. The contact between ball and wall follows damped_hertz.h or, if the bars of the cage
// deform more than the contact does, pocket_wall.h. Coulomb friction, smoothed below the speed
// `creep`, opposes the sliding of the ball's surface on the wall. Forces on ball and cage act
// through one point, so momentum and angular momentum are conserved.
//
// All vectors of a pocket refer to the same frame, which may be any. T is double or, for four balls
// of a cage, Lane.
#pragma once

#include "../laws/damped_hertz.h"
#include "../laws/pocket_wall.h"
#include "cage_ring.h"

namespace raceway {

// Position and motion of a ball in its pocket.
template <class T> struct alignas(sizeof(T)) PocketGapT {
  Vec3T<T> axis;              // of the pocket
  Vec3T<T> lever;             // m, vector from the cage's centre to the ball's centre
  Vec3T<T> velocity, spin;    // of the ball relative to the cage, m/s and rad/s
  T around, beyond;           // m, components of `apart` along the circle and along the axis
  Vec3T<T> apart;             // m, displacement as far as the wall limits it
  T distance;                 // m, its magnitude
  T overlap;                  // m, negative: gap
};

// Returns the part of q (m) by which it exceeds the length `straight` of a slot on either side.
template <class T> RACEWAY_INLINE T beyond_slot(const T &q, double straight)
{
  return where(q > straight, T(q - straight), where(q < -straight, T(q + straight), T(q * 0.0)));
}

// Returns the gap of a ball at `lever` (m) from the cage's centre that moves at `velocity` and
// `spin` relative to the cage. `e` is the axis of the cage, and `axis` that of the pocket.
template <class T>
RACEWAY_INLINE PocketGapT<T> pocket_gap(const CageRing &cage, const Vec3T<T> &e,
                                        const Vec3T<T> &axis, const Vec3T<T> &lever,
                                        const Vec3T<T> &velocity, const Vec3T<T> &spin)
{
  const double clearance = std::fmin(cage.along, cage.across);
  const Vec3T<T> t = cross(e, axis);
  PocketGapT<T> g;
  g.axis = axis;
  g.lever = lever;
  g.velocity = velocity;
  g.spin = spin;
  g.around = beyond_slot(dot(lever, t), cage.along - clearance);
  g.beyond = beyond_slot(dot(lever, e), cage.across - clearance);
  g.apart = t * g.around + e * g.beyond;
  if (cage.spherical) g.apart += axis * (dot(lever, axis) - cage.pitch);
  g.distance = norm(g.apart);
  g.overlap = g.distance - clearance;
  return g;
}

// Forces of the oil in a pocket.
template <class T> struct alignas(sizeof(T)) PocketOilT {
  HalfFilm<T> film = {T(), T()};
  T spring[3] = {}, damper[3] = {};    // derivatives of its coefficients with respect to the
                                       // products of displacement and velocity, as squeeze_film()
  Vec3T<T> velocity;                   // m/s, of the ball as far as the film resists it
  Vec3T<T> force, ball_torque;         // on the ball, N and N m
  Vec3T<T> cage_moment;                // on the cage about its centre, N m
  T loss = {};                         // W

  // Returns the damping constant along the motion, N s/m.
  double resistance() const
  {
    const double vv = dot(velocity, velocity);
    return vv > 0.0 ? -dot(force, velocity) / vv : 0.0;
  }
};

// Returns the forces of the oil on a ball and its cage. The derivatives of the film are included if
// `slopes` is true.
template <class T>
RACEWAY_INLINE PocketOilT<T> pocket_oil(const CageRing &cage, const PocketGapT<T> &gap, bool slopes)
{
  PocketOilT<T> o;
  if (cage.shear > 0.0) {
    const Vec3T<T> couple = (gap.spin + gap.axis * dot(gap.spin, gap.axis)) * cage.shear;
    o.ball_torque = -couple;
    o.cage_moment = couple;
    o.loss = dot(couple, gap.spin);
  }
  if (!(cage.film.viscosity > 0.0)) return o;
  o.velocity = gap.velocity;
  if (!cage.spherical) o.velocity -= gap.axis * dot(gap.velocity, gap.axis);
  const T of[] = {dot(gap.apart, gap.apart), dot(gap.apart, o.velocity),
                  dot(o.velocity, o.velocity)};
  if (slopes) {
    Dual<T, 3> by[] = {of[0], of[1], of[2]};
    for (int k = 0; k < 3; ++k) by[k].d[k] += 1.0;
    const auto f = squeeze_film(cage.film, by[0], by[1], by[2]);
    o.film = {f.spring.value, f.damper.value};
    for (int k = 0; k < 3; ++k) {
      o.spring[k] = f.spring.d[k];
      o.damper[k] = f.damper.d[k];
    }
  } else {
    o.film = squeeze_film(cage.film, of[0], of[1], of[2]);
  }
  o.force = -(gap.apart * o.film.spring + o.velocity * o.film.damper);
  o.loss -= dot(o.force, gap.velocity);
  o.cage_moment -= cross(gap.lever, o.force);
  return o;
}

// Contact between a ball and the wall of its pocket.
struct PocketWall {
  Vec3 normal;    // from wall to ball
  DampedHertz h;
  double bend = 0.0;       // N/m, due to the rotation of the normal as the ball moves in the bore
  Vec3 side;               // direction across the normal in the pocket's cross-section
  Vec3 slide;              // sliding direction of the ball times the fraction of full friction
  double braking = 0.0;    // N s/m, friction divided by sliding speed
  Vec3 force, ball_torque;            // on the ball, N and N m
  Vec3 cage_moment;                   // on the cage about its centre, N m
  double loss = 0.0, energy = 0.0;    // W, J
};

// Evaluates the wall for a ball with the given radius (m) and mass (kg). For gaps up to `close`
// (m), derivatives are evaluated at the overlap `barely` (m), but forces at the actual gap.
PocketWall pocket_wall(const CageRing &, const PocketGapT<double> &, double radius, double mass,
                       double close = 0.0, double barely = 0.0);

struct PocketBall {
  Vec3 x, v, w;
  double radius, mass;
};

// Contact of one ball with oil and wall, in the lab frame.
struct PocketContact {
  PocketGapT<double> gap;
  PocketOilT<double> oil;
  PocketWall wall;

  Vec3 force() const { return oil.force + wall.force; }
  Vec3 ball_torque() const { return oil.ball_torque + wall.ball_torque; }
  Vec3 cage_moment() const { return oil.cage_moment + wall.cage_moment; }
  double loss() const { return oil.loss + wall.loss; }
  // Returns the force that presses the ball and the wall against each other, N.
  double push() const { return norm(oil.force + wall.normal * wall.h.force); }
};

// Returns the contact of a ball in the pocket with this number.
PocketContact pocket_contact(const CageRing &, const CageMotion &, int pocket, const PocketBall &);

}    // namespace raceway
