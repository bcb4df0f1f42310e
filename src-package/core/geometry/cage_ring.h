// SPDX-License-Identifier: GPL-2.0-or-later
// A one-piece cage: equally spaced pockets on the pitch circle (pocket_contact.h), and a land that
// may guide the cage (cage_land.cpp).
//
// A pocket is a slot along its radial axis p. Its half clearances are c_t along the pitch circle
// and c_z along the bearing's axis. In a cylindrical pocket the ball can move freely along p,
// whereas a spherical pocket also holds it in this direction.
#pragma once

#include "../laws/cage_drag.h"
#include "../laws/hertz.h"
#include "../laws/pocket_film.h"
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

  // Returns the azimuth of a pocket relative to the first one, rad.
  double azimuth(int pocket) const { return 2.0 * 3.14159265358979323846 * pocket / pockets; }
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
  return hertz_contact(r, r * (r + land.clearance) / land.clearance, Eprime, Ellipse::exact).K;
}

// Position and motion of the cage. e is its axis, and `angle` is its rotation (rad) about e since
// the start of the run.
struct CageMotion {
  Vec3 x, v, e, w;
  double angle = 0.0;
};

// Returns a direction normal to the bearing's axis, with the components c and s along x and y,
// after the rotation that turns this axis into e.
template <class T> RACEWAY_INLINE Vec3T<T> carried_across(const Vec3 &e, const T &c, const T &s)
{
  const T share = (e.x * c + e.y * s) / (1.0 + e.z);
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
  const double azimuth = m.angle + cage.phase + cage.azimuth(pocket);
  return carried_across(m.e, std::cos(azimuth), std::sin(azimuth));
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
