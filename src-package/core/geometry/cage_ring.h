// SPDX-License-Identifier: GPL-2.0-or-later
// A one-piece cage: equally spaced pockets on the pitch circle, and a land that may guide the cage.
// Both integrators use the same model for the contact between a ball and its pocket.
//
// A pocket is a slot along its radial axis p. Its half clearances are c_t along the pitch circle
// and c_z along the bearing's axis. In a cylindrical pocket the ball can move freely along p,
// whereas a spherical pocket also holds it in this direction. The contact between ball and wall
// follows damped_hertz.h or, if the bars of the cage deform more than the contact does,
// pocket_wall.h. Coulomb friction, smoothed below the speed `creep`, opposes the sliding of the
// ball's surface on the wall. The oil in the pocket resists the relative motion and the relative
// spin (pocket_film.h). Forces on ball and cage act through one point, so momentum and angular
// momentum are conserved.
#ifndef RACEWAY_CAGE_RING_H
#define RACEWAY_CAGE_RING_H

#include "../laws/cage_drag.h"
#include "../laws/damped_hertz.h"
#include "../laws/hertz.h"
#include "../laws/pocket_film.h"
#include "../laws/pocket_wall.h"
#include "../numbers/vec3.h"

namespace raceway {

// Estimates as fractions of the ball's diameter (docs/cage): clearance along the pitch circle,
// height of the oil band in a pocket, radial extent of a cage beyond the pitch circle
constexpr double usual_play = 0.025, usual_band = 0.35, usual_reach = 0.3;

struct CageRing {
  enum Guide { by_balls, by_inner, by_outer };
  int pockets = 0;
  bool spherical = false;
  double pitch = 0.0, phase = 0.0;        // radius of the circle of pockets, m; azimuth of the
                                          // first pocket, rad
  double along = 0.0, across = 0.0;       // half clearances along the circle and along the axis, m
  double stiffness = 0.0;                 // N/m^1.5, contact between ball and wall
  double wall = 0.0;                      // N/m, stiffness of the wall of a pocket with flexible
                                          // bars; 0: Hertz contact
  double mass = 0.0;                      // kg
  double friction = 0.0, creep = 1e-2;    // friction coefficient between ball and wall; creep
                                          // speed, m/s
  double shear = 0.0;                     // N m s, pocket_shear()
  PocketFilm film;                        // squeeze film; without viscosity there is none
  Guide guide = by_balls;
  LandGap land;
  double land_stiffness = 0.0;    // N/m^1.5, contact between cage and land
  double oil_share = 0.0, oil_density = 0.0, oil_viscosity = 0.0, outer_radius = 0.0;    // churning

  // Returns the effective half clearance, m: the smaller half clearance, but at least a thousandth
  // of the ball's radius.
  double least_play(double ball_radius) const
  {
    return std::fmax(std::fmin(along, across), 1e-3 * ball_radius);
  }
  double churning(double speed) const
  {
    return churning_couple(oil_share, oil_density, oil_viscosity, outer_radius, speed);
  }
};

// Returns the stiffness of a ball in the bore of its pocket, N/m^1.5. If the clearance on one side
// is c, the radius of the bore is R + c; along the axis of a cylinder the wall is straight. A bore
// that has no clearance is treated as if its clearance were a thousandth of the ball's radius.
inline double pocket_stiffness(bool spherical, double ball_radius, double play, double Eprime)
{
  const double R = ball_radius, bore = R + std::fmax(play, 1e-3 * R);
  const double around = 1.0 / (1.0 / R - 1.0 / bore);
  return hertz_contact(spherical ? around : R, around, Eprime, Ellipse::exact).K;
}

// Returns the stiffness of the contact between a cage and its land, N/m^1.5. Along the circle of
// the land the radii differ by the clearance; the curvature of the land across the circle is
// assumed to equal that of the circle.
inline double land_stiffness(const LandGap &land, double Eprime)
{
  const double r = land.radius;
  return hertz_contact(r * (r + land.clearance) / land.clearance, r, Eprime, Ellipse::exact).K;
}

// Position and motion of the cage. e is its axis, and `angle` is its rotation (rad) about e since
// the start of the run.
struct CageMotion {
  Vec3 x, v, e, w;
  double angle = 0.0;
};

// Returns a direction normal to the bearing's axis after the rotation that turns this axis into e.
inline Vec3 carried_across(const Vec3 &e, double c, double s)
{
  const double share = (e.x * c + e.y * s) / (1.0 + e.z);
  return {c - share * e.x, s - share * e.y, -share * (1.0 + e.z)};
}

// Returns the number of the pocket of a ball at d (m) from the cage's centre.
inline int pocket_at(const CageRing &cage, const CageMotion &m, const Vec3 &d)
{
  const double turn = 2.0 * 3.14159265358979323846;
  const double azimuth =
      std::atan2(dot(d, carried_across(m.e, 0.0, 1.0)), dot(d, carried_across(m.e, 1.0, 0.0)));
  const double share = (azimuth - m.angle - cage.phase) / turn;
  const int k = static_cast<int>(std::lround((share - std::floor(share)) * cage.pockets));
  return k % cage.pockets;
}

// Returns the direction from the cage's centre to the centre of a pocket.
inline Vec3 pocket_axis(const CageRing &cage, const CageMotion &m, int pocket)
{
  const double turn = 2.0 * 3.14159265358979323846;
  const double azimuth = m.angle + cage.phase + turn * pocket / cage.pockets;
  return carried_across(m.e, std::cos(azimuth), std::sin(azimuth));
}

// Squeeze film between a ball and its pocket, in the lab frame.
struct PocketSqueeze {
  Vec3 x, v;    // displacement (m) and velocity (m/s) of the ball, as far as the film resists them
  SqueezeFilm<double> of = {0.0, 0.0};
  double spring[3] = {}, damper[3] = {};    // derivatives of its coefficients with respect to x.x,
                                            // x.v and v.v
  Vec3 force;                               // on the ball, N

  // Returns the damping constant along the motion, N s/m.
  double resistance() const { return dot(v, v) > 0.0 ? -dot(force, v) / dot(v, v) : 0.0; }
};

struct PocketContact {
  Vec3 offset;       // m, from the pocket's centre to the ball's centre: components along the
                     // circle, the axis and the radius
  double overlap;    // m, negative: gap
  Vec3 normal;       // from wall to ball
  Vec3 lever;        // m, vector from the cage's centre to the ball's centre
  DampedHertz h;
  double rate = 0.0;    // m/s, rate of the overlap
  double bend = 0.0;    // N/m, due to the rotation of the normal as the ball moves in the bore
  Vec3 side, axis;      // direction across the normal in the pocket's cross-section; axis of the
                        // pocket
  bool spherical = false;
  PocketSqueeze film;
  Vec3 slide;                 // sliding direction of the ball times the fraction of full friction
  double braking = 0.0;       // N s/m, friction divided by sliding speed
  Vec3 force, ball_torque;    // on the ball, N and N m
  Vec3 cage_moment;           // on the cage about its centre, N m
  double loss = 0.0, energy = 0.0;    // W, J

  // Returns the force that presses the ball and the wall against each other, N.
  double push() const { return norm(film.force + normal * h.force); }
};

struct PocketBall {
  Vec3 x, v, w;
  double radius, mass;
};

// Evaluates the squeeze film of a ball displaced by x (m) that moves at v (m/s) in its pocket, and
// the derivatives of its coefficients if `slopes` is true.
inline PocketSqueeze pocket_squeeze(const PocketFilm &film, const Vec3 &x, const Vec3 &v,
                                    bool slopes)
{
  PocketSqueeze s;
  s.x = x;
  s.v = v;
  const double of[] = {dot(x, x), dot(x, v), dot(v, v)};
  if (slopes) {
    Dual<double, 3> by[] = {of[0], of[1], of[2]};
    for (int k = 0; k < 3; ++k) by[k].d[k] = 1.0;
    const auto f = squeeze_film(film, by[0], by[1], by[2]);
    s.of = {f.spring.value, f.damper.value};
    for (int k = 0; k < 3; ++k) {
      s.spring[k] = f.spring.d[k];
      s.damper[k] = f.damper.d[k];
    }
  } else {
    s.of = squeeze_film(film, of[0], of[1], of[2]);
  }
  s.force = -(x * s.of.spring + v * s.of.damper);
  return s;
}

// Evaluates the contact between a ball and its pocket. For gaps up to `close` (m), derivatives are
// evaluated at the overlap `barely` (m), but forces at the actual gap. `slopes` asks for the
// derivatives of the film.
inline PocketContact pocket_contact(const CageRing &cage, const CageMotion &m, int pocket,
                                    const PocketBall &ball, double close = 0.0, double barely = 0.0,
                                    bool slopes = false)
{
  PocketContact c;
  const Vec3 p = pocket_axis(cage, m, pocket), t = cross(m.e, p), d = ball.x - m.x;
  c.lever = d;
  c.axis = p;
  c.spherical = cage.spherical;
  c.offset = {dot(d, t), dot(d, m.e), dot(d, p) - cage.pitch};
  const double gap = std::fmin(cage.along, cage.across);
  const auto beyond = [](double q, double straight) {
    return q > straight ? q - straight : q < -straight ? q + straight : 0.0;
  };
  const double qt = beyond(c.offset.x, cage.along - gap),
               qz = beyond(c.offset.y, cage.across - gap), qr = cage.spherical ? c.offset.z : 0.0;
  const double off = std::sqrt(qt * qt + qz * qz + qr * qr);
  c.overlap = off - gap;
  const Vec3 spin = ball.w - m.w, dv = ball.v - m.v - cross(m.w, d);
  if (cage.shear > 0.0) {
    const Vec3 couple = (spin + p * dot(spin, p)) * cage.shear;
    c.ball_torque = -couple;
    c.cage_moment = couple;
    c.loss = dot(couple, spin);
  }
  if (cage.film.viscosity > 0.0) {
    const Vec3 x = t * qt + m.e * qz + p * qr;
    c.film = pocket_squeeze(cage.film, x, cage.spherical ? dv : dv - p * dot(dv, p), slopes);
    c.force = c.film.force;
    c.loss -= dot(c.film.force, dv);
    c.cage_moment -= cross(d, c.film.force);
  }
  if (!(off > 0.0) || c.overlap <= -close) return c;
  const Vec3 n = (t * qt + m.e * qz + p * qr) * (-1.0 / off);
  c.normal = n;
  c.side = cage.spherical ? Vec3() : cross(p, n);
  c.rate = -dot(dv, n);
  const double reduced = ball.mass * cage.mass / (ball.mass + cage.mass);
  const bool touches = c.overlap > 0.0;
  const double overlap = touches ? c.overlap : barely, rate = touches ? c.rate : 0.0;
  c.h = cage.wall > 0.0 ? damped_wall(cage.wall, full_damping * cage.least_play(ball.radius),
                                      overlap, rate, reduced)
                        : damped_hertz(cage.stiffness, overlap, rate, reduced);
  if (!touches) {
    c.h.force = 0.0;
    return c;
  }
  const double linear = c.h.stiffness * c.overlap;
  const double spring = cage.wall > 0.0 ? linear : linear / 1.5;
  c.energy = (cage.wall > 0.0 ? 0.5 : 0.4) * spring * c.overlap;
  c.loss += (c.h.force - spring) * c.rate;
  if (!(c.h.force > 0.0)) return c;
  // if the half clearances differ, the slot has straight walls, and the normal on them does not
  // rotate
  const bool turns = cage.spherical || cage.along == cage.across || (qt != 0.0 && qz != 0.0);
  c.bend = turns ? c.h.force / off : 0.0;
  Vec3 push = n * c.h.force;
  const Vec3 at = n * -ball.radius;    // from the ball's centre to the wall
  if (cage.friction > 0.0) {
    const Vec3 on = dv + cross(spin, at), v = on - n * dot(on, n);
    c.braking = cage.friction * c.h.force / std::sqrt(dot(v, v) + cage.creep * cage.creep);
    c.slide = v * (c.braking / c.h.force);
    push -= v * c.braking;
    c.ball_torque -= cross(at, v * c.braking);
    c.loss += c.braking * dot(v, v);
  }
  c.force += push;
  c.cage_moment -= cross(d + at, push);
  return c;
}

// Force and moment between a cage and the ring whose land guides it. The force acts at the cage's
// centre, and on the ring through the same point.
struct LandContact {
  Vec3 force, moment;                               // on the cage, N and N m
  Vec3 lever;                                       // m, from ring centre to cage centre
  double displaced[2][2] = {}, moved[2][2] = {};    // -d force/d position and -d force/d velocity
  Vec3 axis[2];                                     // axes of these matrices, normal to the ring's
                                                    // axis
  double loss = 0.0, energy = 0.0;                  // W, J
  double share = 0.0;                               // eccentricity divided by clearance
  double push = 0.0, stiffness = 0.0;               // force (N) and stiffness (N/m) of the surfaces
                                                    // in contact
};

LandContact land_contact(const CageRing &, const CageMotion &cage, const CageMotion &ring);

}    // namespace raceway

#endif
