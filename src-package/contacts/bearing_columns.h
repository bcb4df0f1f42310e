// SPDX-License-Identifier: GPL-2.0-or-later
// Columns of balls, rings and whole bearings, a line each, in the order of their numbers. No host
// here.
#ifndef BEARING_BEARING_COLUMNS_H
#define BEARING_BEARING_COLUMNS_H

#include "../physics/column.h"

namespace bearing {

using raceway::as_whole;
using raceway::Column;

// ---- compute bearing/ball, beside the columns of its two contacts
namespace of_ball {
enum { AZIMUTH, ORBIT, TURN_W, TURN_X, TURN_Y, TURN_Z, N };
const Column list[N] = {
    {"azimuth", "rad", "azimuth of the ball about the bearing's axis, from the lab's x"},
    {"orbit", "rad/s", "speed of the ball's centre about the ring's axis"},
    {"turn_w", "", "turn of the ball since the start, a unit quaternion: cosine of half the angle"},
    {"turn_x", "",
     "component along x of that quaternion's vector: sine of half the angle times axis"},
    {"turn_y", "", "component along y of that quaternion's vector"},
    {"turn_z", "", "component along z of that quaternion's vector"},
};
inline bool needs_turn(int k) { return k >= TURN_W; }
}    // namespace of_ball

// ---- compute bearing/ring
namespace of_ring {
enum {
  RING,
  X,
  Y,
  Z,
  VX,
  VY,
  VZ,
  SPIN,
  ANGLE,
  TILT_1,
  TILT_2,
  FX,
  FY,
  FZ,
  MX,
  MY,
  MZ,
  TORQUE,
  AX,
  AY,
  AZ,
  CONTACTS,
  BALLS,
  LOAD,
  PRESSURE,
  H_MIN,
  LAMBDA,
  ORBIT,
  FRICTION_POWER,
  DAMPING_POWER,
  CAPACITANCE,
  CAPACITANCE_TOTAL,
  N
};
const Column list[N] = {
    {"ring", "", "atom number of the ring", raceway::has_none, as_whole},
    {"x", "m", "displacement of the ring along x, from the start"},
    {"y", "m", "displacement of the ring along y, from the start"},
    {"z", "m", "displacement of the ring along z, from the start"},
    {"vx", "m/s", "velocity of the ring along x"},
    {"vy", "m/s", "velocity of the ring along y"},
    {"vz", "m/s", "velocity of the ring along z"},
    {"spin", "rad/s", "spin of the ring about its axis"},
    {"angle", "rad", "turned about its axis, from the start"},
    {"tilt_1", "rad", "tilt of the ring about the first axis across the bearing's (x for z)"},
    {"tilt_2", "rad", "tilt of the ring about the second axis across the bearing's (y for z)"},
    {"fx", "N", "force of balls and cage on the ring along x"},
    {"fy", "N", "force of balls and cage on the ring along y"},
    {"fz", "N", "force of balls and cage on the ring along z"},
    {"mx", "N m", "moment of balls and cage on the ring about x"},
    {"my", "N m", "moment of balls and cage on the ring about y"},
    {"mz", "N m", "moment of balls and cage on the ring about z"},
    {"torque", "N m", "moment of balls and cage about the ring's axis, its friction"},
    {"ax", "m/s^2", "acceleration of the ring along x, 0 where the displacement is not free"},
    {"ay", "m/s^2", "acceleration of the ring along y, 0 where the displacement is not free"},
    {"az", "m/s^2", "acceleration of the ring along z, 0 where the displacement is not free"},
    {"contacts", "", "contacts of balls with the ring", raceway::has_none, as_whole},
    {"balls", "", "balls on the ring in contact with both raceways", raceway::has_none, as_whole},
    {"load", "N", "largest elastic contact load"},
    {"pressure", "Pa", "largest Hertz pressure"},
    {"h_min", "m", "smallest minimum film thickness of the contacts"},
    {"lambda", "", "smallest film parameter of the contacts"},
    {"orbit", "rad/s", "mean speed of the balls about the ring's axis"},
    {"friction_power", "W", "power lost to tangential forces"},
    {"damping_power", "W", "power lost to normal damping"},
    {"capacitance", "F", "sum over balls in contact with both raceways, their two in series"},
    {"capacitance_total", "F", "sum over all balls with their surroundings, their two in series"},
};
inline bool needs_capacitance(int k) { return k == CAPACITANCE || k == CAPACITANCE_TOTAL; }
inline bool needs_film(int k) { return k == H_MIN || k == LAMBDA || needs_capacitance(k); }
}    // namespace of_ring

// ---- compute bearing/total: all bearings of the run
namespace of_total {
enum {
  CONTACTS,
  LOADED_BALLS,
  LOAD_INNER,
  LOAD_OUTER,
  PRESSURE,
  H_MIN,
  LAMBDA,
  CAGE_SPEED,
  FRICTION_POWER,
  DAMPING_POWER,
  CAGE_FORCE,
  N
};
const Column list[N] = {
    {"contacts", "", "contacts of balls with raceways", raceway::has_none, as_whole},
    {"loaded_balls", "", "balls in contact with both raceways", raceway::has_none, as_whole},
    {"load_inner", "N", "largest elastic contact load on the inner raceway"},
    {"load_outer", "N", "largest elastic contact load on the outer raceway"},
    {"pressure", "Pa", "largest Hertz pressure"},
    {"h_min", "m", "smallest minimum film thickness of the contacts; 0 when dry"},
    {"lambda", "", "smallest film parameter of the contacts; 0 when dry"},
    {"cage_speed", "rad/s", "mean speed of the balls about the axis of their ring"},
    {"friction_power", "W", "power lost to tangential forces"},
    {"damping_power", "W", "power lost to normal damping"},
    {"cage_force", "N", "largest contact force of ball and cage ball"},
};
}    // namespace of_total

// ---- one bearing in a record: sums and extremes over its balls
namespace of_bearing {
enum {
  CONTACTS,
  LOADED_BALLS,
  LOAD_INNER,
  LOAD_OUTER,
  PRESSURE_INNER,
  PRESSURE_OUTER,
  H_MIN,
  LAMBDA,
  CAGE_SPEED,
  FRICTION_POWER,
  DAMPING_POWER,
  ENTRAINMENT_TOP,
  H_MIN_TOP,
  LAMBDA_TOP,
  H_C_TOP,
  CAPACITANCE,
  CAPACITANCE_TOP,
  ROLLING_POWER,
  HYSTERESIS_POWER,
  SPIN_POWER,
  DRAG_POWER,
  CAGE_POWER,
  CAGE_FORCE,
  ASPERITY_SHARE_TOP,
  CAPACITANCE_TOTAL,
  CAPACITANCE_TOTAL_TOP,
  N
};
const Column list[N] = {
    {"contacts", "", "contacts of balls with raceways", raceway::has_none, as_whole},
    {"loaded_balls", "", "balls in contact with both raceways", raceway::has_none, as_whole},
    {"load_inner", "N", "largest elastic contact load on the inner raceway"},
    {"load_outer", "N", "largest elastic contact load on the outer raceway"},
    {"pressure_inner", "Pa", "largest Hertz pressure on the inner raceway"},
    {"pressure_outer", "Pa", "largest Hertz pressure on the outer raceway"},
    {"h_min", "m", "smallest film thickness of the contacts"},
    {"lambda", "", "smallest film parameter of the contacts"},
    {"cage_speed", "rad/s", "mean speed of the balls about the axis of the outer ring"},
    {"friction_power", "W", "power lost to tangential forces"},
    {"damping_power", "W", "power lost to normal damping"},
    {"entrainment_top", "m/s", "entrainment speed at the largest load on the inner raceway"},
    {"h_min_top", "m", "smallest film thickness at the largest load on the inner raceway"},
    {"lambda_top", "", "film parameter at the largest load on the inner raceway"},
    {"h_c_top", "m", "central film thickness at the largest load on the inner raceway"},
    {"capacitance", "F", "capacitance of the bearing, without background"},
    {"capacitance_top", "F", "largest capacitance of one ball, its two contacts in series"},
    {"rolling_power", "W", "power lost to the hydrodynamic couple"},
    {"hysteresis_power", "W", "power lost to hysteresis in rolling"},
    {"spin_power", "W", "power lost to spin"},
    {"drag_power", "W", "power lost to drag of the oil on balls"},
    {"cage_power", "W", "power lost between balls and cage balls"},
    {"cage_force", "N", "largest contact force of balls with cage balls or one another"},
    {"asperity_share_top", "", "share of asperities at the largest load on the inner raceway"},
    {"capacitance_total", "F", "capacitance of all balls with their surroundings, no background"},
    {"capacitance_total_top", "F", "largest of one ball with its surroundings, both in series"},
};
inline bool needs_surroundings(int k) { return k >= CAPACITANCE_TOTAL; }
// with a law that has couples
inline bool needs_couples(int k) { return k >= ROLLING_POWER && k <= CAGE_POWER; }
}    // namespace of_bearing

// ---- what a bearing is, without time
namespace of_kind {
enum {
  BALLS,
  BALL_DIAMETER,
  INNER_RADIUS,
  OUTER_RADIUS,
  INNER_GROOVE,
  OUTER_GROOVE,
  CLEARANCE,
  CAGE_BALLS,
  CAGE_BALL_DIAMETER,
  BALL_MASS,
  BALL_YOUNG,
  BALL_POISSON,
  RING_YOUNG,
  RING_POISSON,
  VISCOSITY,
  PRESSURE_VISCOSITY,
  PERMITTIVITY,
  RING_ROUGHNESS,
  BALL_ROUGHNESS,
  INNER_ARCH,
  OUTER_ARCH,
  N
};
const Column list[N] = {
    {"balls", "", "number of balls", raceway::has_none, as_whole},
    {"ball_diameter", "m", "diameter of a ball"},
    {"inner_radius", "m", "radius of the inner raceway at the bottom of its groove"},
    {"outer_radius", "m", "radius of the outer raceway at the bottom of its groove"},
    {"inner_groove", "m", "radius of the groove of the inner raceway, in section"},
    {"outer_groove", "m", "radius of the groove of the outer raceway, in section"},
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
    {"inner_arch", "m", "inner ring with two grooves: of their centres from its middle plane"},
    {"outer_arch", "m", "outer ring with two grooves: of their centres from its middle plane"},
};
inline bool of_two_grooves(int k) { return k == INNER_ARCH || k == OUTER_ARCH; }
}    // namespace of_kind

// ---- balls, cage balls and rings as the host has them
namespace of_atom {
enum { MOTION = 2 };    // the first of place, velocity and spin
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

#endif
