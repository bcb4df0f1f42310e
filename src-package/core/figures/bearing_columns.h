// SPDX-License-Identifier: GPL-2.0-or-later
// Columns for balls, for the motion of rings and for the constant data of a bearing, with one line
// per column in numerical order. Sums and extremes are in bearing_figures.h. This file does not
// depend on the host.
#pragma once

#include "../numbers/column.h"

namespace bearing {

using raceway::as_whole;
using raceway::Column;

// ---- compute bearing/ball, in addition to the columns of its two contacts
namespace of_ball {
enum { AZIMUTH, ORBIT, TURN_W, TURN_X, TURN_Y, TURN_Z, N };
const Column list[N] = {
    {"azimuth", "rad", "azimuth of the ball about the bearing axis, measured from the lab x axis"},
    {"orbit", "rad/s", "speed of the ball's centre about the ring's axis"},
    {"turn_w", "",
     "rotation of the ball since the start as a unit quaternion: cosine of half the angle"},
    {"turn_x", "",
     "x component of the vector part of that quaternion: sine of half the angle times the axis"},
    {"turn_y", "", "y component of the vector part of that quaternion"},
    {"turn_z", "", "z component of the vector part of that quaternion"},
};
inline bool needs_turn(int k) { return k >= TURN_W; }
}    // namespace of_ball

// ---- motion of a ring, and loads on the ring
namespace of_ring {
// clang-format off
enum {
  RING,
  X, Y, Z, VX, VY, VZ, SPIN, ANGLE, TILT_1, TILT_2,
  FX, FY, FZ, MX, MY, MZ, TORQUE,
  AX, AY, AZ, N
};
// clang-format on
const Column list[N] = {
    {"ring", "", "atom number of the ring", raceway::has_none, as_whole},
    {"x", "m", "displacement of the ring along x, relative to the start"},
    {"y", "m", "displacement of the ring along y, relative to the start"},
    {"z", "m", "displacement of the ring along z, relative to the start"},
    {"vx", "m/s", "velocity of the ring along x"},
    {"vy", "m/s", "velocity of the ring along y"},
    {"vz", "m/s", "velocity of the ring along z"},
    {"spin", "rad/s", "spin of the ring about its axis"},
    {"angle", "rad", "rotation of the ring about its axis since the start"},
    {"tilt_1", "rad", "tilt of the ring about the first transverse axis (x for bearing axis z)"},
    {"tilt_2", "rad", "tilt of the ring about the second transverse axis (y for bearing axis z)"},
    {"fx", "N", "force of balls and cage on the ring along x"},
    {"fy", "N", "force of balls and cage on the ring along y"},
    {"fz", "N", "force of balls and cage on the ring along z"},
    {"mx", "N m", "moment of balls and cage on the ring about x"},
    {"my", "N m", "moment of balls and cage on the ring about y"},
    {"mz", "N m", "moment of balls and cage on the ring about z"},
    {"torque", "N m", "moment of balls and cage about the ring's axis, i.e. the friction torque"},
    {"ax", "m/s^2",
     "acceleration of the ring along x, which is 0 if this displacement is not free"},
    {"ay", "m/s^2",
     "acceleration of the ring along y, which is 0 if this displacement is not free"},
    {"az", "m/s^2",
     "acceleration of the ring along z, which is 0 if this displacement is not free"},
};
}    // namespace of_ring

// ---- constant data of a bearing
namespace of_kind {
// clang-format off
enum {
  BALLS, BALL_DIAMETER, INNER_RADIUS, OUTER_RADIUS, INNER_GROOVE, OUTER_GROOVE, CLEARANCE,
  CAGE_BALLS, CAGE_BALL_DIAMETER,
  BALL_MASS, BALL_YOUNG, BALL_POISSON, RING_YOUNG, RING_POISSON,
  VISCOSITY, PRESSURE_VISCOSITY, PERMITTIVITY, RING_ROUGHNESS, BALL_ROUGHNESS,
  INNER_ARCH, OUTER_ARCH, N
};
// clang-format on
const Column list[N] = {
    {"balls", "", "number of balls", raceway::has_none, as_whole},
    {"ball_diameter", "m", "diameter of a ball"},
    {"inner_radius", "m", "radius of the inner raceway at the bottom of its groove"},
    {"outer_radius", "m", "radius of the outer raceway at the bottom of its groove"},
    {"inner_groove", "m", "radius of the inner raceway's groove in cross-section"},
    {"outer_groove", "m", "radius of the outer raceway's groove in cross-section"},
    {"clearance", "m", "diametral clearance; negative is preload"},
    {"cage_balls", "", "number of cage balls", raceway::has_none, as_whole},
    {"cage_ball_diameter", "m", "diameter of a cage ball"},
    {"ball_mass", "kg", "mass of a ball"},
    {"ball_young", "Pa", "Young's modulus of the balls"},
    {"ball_poisson", "", "Poisson's ratio of the balls"},
    {"ring_young", "Pa", "Young's modulus of the inner ring"},
    {"ring_poisson", "", "Poisson's ratio of the inner ring"},
    {"viscosity", "Pa s", "viscosity of the lubricant"},
    {"pressure_viscosity", "1/Pa", "pressure-viscosity coefficient of the lubricant"},
    {"permittivity", "", "relative permittivity of the lubricant at ambient pressure"},
    {"ring_roughness", "m", "roughness of the inner raceway"},
    {"ball_roughness", "m", "roughness of the balls"},
    {"inner_arch", "m",
     "distance of the two groove centres from the middle plane of the inner ring"},
    {"outer_arch", "m",
     "distance of the two groove centres from the middle plane of the outer ring"},
};
inline bool of_two_grooves(int k) { return k == INNER_ARCH || k == OUTER_ARCH; }
}    // namespace of_kind

// ---- balls, cage balls and rings as stored by the host
namespace of_atom {
enum { MOTION = 2 };    // index of the first of position, velocity and spin
const Column list[] = {
    {"id", "", "atom number", raceway::has_none, as_whole},
    {"type", "", "1 ball, 2 cage ball, 3 inner ring, 4 outer ring", raceway::has_none, as_whole},
    {"x", "m", "position along x"},
    {"y", "m", "position along y"},
    {"z", "m", "position along z"},
    {"vx", "m/s", "velocity along x"},
    {"vy", "m/s", "velocity along y"},
    {"vz", "m/s", "velocity along z"},
    {"omegax", "rad/s", "spin about x"},
    {"omegay", "rad/s", "spin about y"},
    {"omegaz", "rad/s", "spin about z"},
};
}    // namespace of_atom

}    // namespace bearing
