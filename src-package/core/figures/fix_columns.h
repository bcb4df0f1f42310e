// SPDX-License-Identifier: GPL-2.0-or-later
// Output of the fixes as f_ID[k], with one line per value in numerical order. The sizes of the
// vectors and the tables in the documentation are derived from this file, which does not depend on
// the host.
#pragma once

#include "../numbers/column.h"

namespace bearing {

using raceway::as_whole;
using raceway::Column;

// ---- fix bearing/ring, one row per ring; the radial axes are the two axes of the lab frame that
// are normal to the bearing axis
namespace of_fix_ring {
// clang-format off
enum {
  X, Y, Z, VX, VY, VZ, TILT1, TILT2, SPIN, ANGLE,
  FX, FY, FZ, MX, MY, MZ, TORQUE,
  LOAD_X, LOAD_Y, LOAD_Z, SUPPORT_X, SUPPORT_Y, SUPPORT_Z,
  AX, AY, AZ, N
};
// clang-format on
const Column list[N] = {
    {"x", "m", "displacement along x since the start"},
    {"y", "m", "displacement along y since the start"},
    {"z", "m", "displacement along z since the start"},
    {"vx", "m/s", "velocity along x"},
    {"vy", "m/s", "velocity along y"},
    {"vz", "m/s", "velocity along z"},
    {"tilt_1", "rad", "tilt about the first transverse axis"},
    {"tilt_2", "rad", "tilt about the second transverse axis"},
    {"spin", "rad/s", "spin about the ring's axis"},
    {"angle", "rad", "rotation about the ring's axis since the start"},
    {"fx", "N", "force of balls and cage on the ring along x, without the load"},
    {"fy", "N", "force of balls and cage on the ring along y, without the load"},
    {"fz", "N", "force of balls and cage on the ring along z, without the load"},
    {"mx", "N m", "moment of balls and cage about the x axis through the ring's centre"},
    {"my", "N m", "moment of balls and cage about the y axis through the ring's centre"},
    {"mz", "N m", "moment of balls and cage about the z axis through the ring's centre"},
    {"torque", "N m", "moment of balls and cage about the ring's axis, i.e. the friction torque"},
    {"load_x", "N", "load on the ring along x: force, rotating force and unbalance"},
    {"load_y", "N", "load on the ring along y: force, rotating force and unbalance"},
    {"load_z", "N", "load on the ring along z"},
    {"support_x", "N", "force of the supports on the ring along x"},
    {"support_y", "N", "force of the supports on the ring along y"},
    {"support_z", "N", "force of the supports on the ring along z"},
    {"ax", "m/s^2", "acceleration along x; 0 if the displacement is not free"},
    {"ay", "m/s^2", "acceleration along y; 0 if the displacement is not free"},
    {"az", "m/s^2", "acceleration along z; 0 if the displacement is not free"},
};
}    // namespace of_fix_ring

// ---- fix bearing/shaft with *flexible*: appended to the row of a ring
namespace of_bend {
enum { X, Y, Z, TILT1, TILT2, N };
const Column list[N] = {
    {"bend_x", "m", "displacement along x by bending, relative to the rigid shaft"},
    {"bend_y", "m", "displacement along y by bending"},
    {"bend_z", "m", "displacement along z by bending; 0 in the direction of the shaft"},
    {"bend_tilt_1", "rad", "slope due to bending, as a tilt about the first transverse axis"},
    {"bend_tilt_2", "rad", "slope due to bending, as a tilt about the second transverse axis"},
};
}    // namespace of_bend

// ---- fix bearing/cage/ring: appended to the row of a ring
namespace of_cage {
enum { MAX, SUM, LOSS, ECCENTRICITY, N };
const Column list[N] = {
    {"pocket_max", "N", "largest force of a ball on its pocket"},
    {"pocket_sum", "N", "sum of the forces of balls on their pockets"},
    {"loss", "W", "power dissipated in pockets, at the guiding land and by churning"},
    {"eccentricity", "",
     "eccentricity of the cage in the ring that guides it, relative to the clearance"},
};
}    // namespace of_cage

// ---- fix bearing/implicit: totals over all bearings of the fix since the start of the run
namespace of_fix_implicit {
// clang-format off
enum {
  MEAN_STEP, SMALLEST_STEP, STEPS, CORRECTIONS, REFUSED, ERROR,
  WORK, DISSIPATED, STORED, LOST, N
};
// clang-format on
const Column list[N] = {
    {"mean_step", "s", "mean internal step"},
    {"smallest_step", "s", "smallest internal step"},
    {"steps", "", "number of internal steps", raceway::has_none, as_whole},
    {"corrections", "", "mean number of corrections per internal step"},
    {"refused", "", "number of internal steps that were rejected and repeated", raceway::has_none,
     as_whole},
    {"error", "m",
     "largest estimated error that was accepted; with *solve damping*, the largest movement"},
    {"work", "J",
     "work of loads and driven motions; this and the next 3 values are 0 without *energy yes*"},
    {"dissipated", "J",
     "energy dissipated in films, by hysteresis, by sliding, at the cage and in dampers"},
    {"stored", "J",
     "increase of the kinetic energy and of the energy in contact springs and bent shafts"},
    {"lost", "J", "energy lost by the integrator, i.e. work minus dissipated minus stored"},
};
}    // namespace of_fix_implicit

// ---- fix bearing/cage: values at the last step
namespace of_fix_cage {
enum { SUM, LARGEST, N };
const Column list[N] = {
    {"rail_force_sum", "N", "sum of all rail forces"},
    {"rail_force", "N", "largest force of a rail on a cage ball"},
};
}    // namespace of_fix_cage

// ---- fix bearing/capacitance
namespace of_fix_capacitance {
// clang-format off
enum {
  TOTAL, LARGEST, ACTIVE, MEAN, LEAST, MOST,
  ALL_TOTAL, ALL_LARGEST, ALL_MEAN, ALL_LEAST, ALL_MOST,
  LEAK, IMPEDANCE, PHASE, THRESHOLD, THRESHOLD_LOCAL, THRESHOLD_ENERGY, HERTZ_AREA, N
};
// clang-format on
constexpr int first_of_films = LEAK;    // LEAK and all values after it are results for the films
const Column list[N] = {
    {"total", "F", "sum over the balls, with background, at the end of the step"},
    {"largest", "F", "largest value of one ball at the end of the step"},
    {"balls", "", "number of balls in contact with both raceways", raceway::has_none, as_whole},
    {"mean", "F", "mean of the total over the instants of the step"},
    {"least", "F", "smallest total over the instants of the step"},
    {"most", "F", "largest total over the instants of the step"},
    {"capacitance_total", "F",
     "total with surroundings; this and the next 4 values are 0 unless requested"},
    {"capacitance_total_top", "F", "largest value of one ball with its surroundings"},
    {"capacitance_total_mean", "F", "mean of capacitance_total over the instants of the step"},
    {"capacitance_total_least", "F", "smallest capacitance_total over the instants of the step"},
    {"capacitance_total_most", "F", "largest capacitance_total over the instants of the step"},
    {"leak", "ohm", "resistance of the films to direct current; 0 without *resistivity*"},
    {"impedance", "ohm", "modulus of the impedance; this and the phase are 0 without *frequency*"},
    {"phase", "rad", "phase of the impedance"},
    {"threshold_voltage", "V", "smallest voltage at which a film fails; 0 without *strength*"},
    {"threshold_voltage_local", "V",
     "threshold_voltage of films reduced by three times the roughness"},
    {"threshold_energy", "J", "energy of the bearing and background at threshold_voltage"},
    {"hertz_area", "m2", "area of all contact ellipses; 0 without these three keywords"},
};
}    // namespace of_fix_capacitance

// ---- fix bearing/circuit: values at the last sample, after its discharge; work, heat and counts
// are totals since the first sample
namespace of_fix_circuit {
// clang-format off
enum {
  VOLTAGE, DRIVING, CAPACITANCE, RATIO, THRESHOLD,
  DISCHARGES, FAILURES, DISCHARGE_ENERGY,
  SOURCE_WORK, MECHANICAL_WORK, LEAK_HEAT, RESISTOR_HEAT, STORED,
  CHARGE_ERROR, ENERGY_ERROR, CURRENT, N
};
// clang-format on
const Column list[N] = {
    {"bearing_voltage", "V", "voltage of the inner ring to the outer ring"},
    {"driving_voltage", "V", "voltage of the outer circuit"},
    {"bearing_capacitance", "F", "capacitance between the rings, balls without charge"},
    {"bearing_voltage_ratio", "", "bearing voltage over common-mode voltage; 0 without a motor"},
    {"threshold_voltage", "V",
     "smallest voltage at which a film fails; 0 if no film can fail or one is bridged"},
    {"discharges", "", "number of discharges", raceway::has_none, as_whole},
    {"failures", "", "number of films that failed", raceway::has_none, as_whole},
    {"discharge_energy", "J", "heat of discharges"},
    {"source_work", "J", "work of the driving voltage"},
    {"mechanical_work", "J", "work done by moving the plates of the films"},
    {"leak_heat", "J", "heat in the conductance of films"},
    {"resistor_heat", "J", "heat in the resistance of the source"},
    {"stored_energy", "J", "energy stored in films, beside them and in the coupling"},
    {"charge_error", "C",
     "largest difference between the charges of a node from currents and from voltages"},
    {"energy_error", "J", "largest error of the energy balance of a step"},
    {"current", "A", "mean current into the inner ring's films in the last step of the circuit"},
};
}    // namespace of_fix_circuit

// ---- fix bearing/heat, these are also the columns of its file
namespace of_fix_heat {
// clang-format off
enum {
  TIME, INNER, BALLS, OUTER, HOUSING, OIL,
  POWER, HEAT_INNER, HEAT_BALLS, HEAT_OUTER, CONTACTS_INNER, CONTACTS_OUTER,
  BOOKED, CARRIED, STORED, CLEARANCE, GAIN, JUMP, CORRECTION, RUN,
  HEAT_OIL, OUTLET, N
};
// clang-format on
const Column list[N] = {
    {"thermal_time", "s", "time by which the temperatures have advanced"},
    {"temperature_inner", "degC", "temperature of the inner ring"},
    {"temperature_balls", "degC", "temperature of the balls"},
    {"temperature_outer", "degC", "temperature of the outer ring"},
    {"temperature_housing", "degC", "temperature of the housing"},
    {"temperature_oil", "degC", "temperature of the oil in the contacts, mean of rings and balls"},
    {"power", "W", "losses of a bearing, averaged over the last ball pass"},
    {"heat_inner", "W", "part of the losses that heats the inner ring"},
    {"heat_balls", "W", "part of the losses that heats the balls"},
    {"heat_outer", "W", "part of the losses that heats the outer ring"},
    {"contacts_inner", "W/K",
     "conductance of the inner contacts, averaged over the last ball pass"},
    {"contacts_outer", "W/K",
     "conductance of the outer contacts, averaged over the last ball pass"},
    {"booked", "J", "heat generated by the losses over the thermal time"},
    {"carried", "J", "heat carried away to ambient and by flowing oil"},
    {"stored", "J", "heat stored in rings, balls and housing"},
    {"clearance", "m", "diametral clearance of the warm parts; negative is preload"},
    {"gain", "",
     "change of losses with temperature divided by the conductance; thermal runaway from 1 on"},
    {"jump", "s", "thermal time of the last jump"},
    {"correction", "K", "largest difference between predicted and final temperatures of that jump"},
    {"run_time", "s", "simulated time since the fix began"},
    {"heat_oil", "W", "part of the losses that heats flowing oil"},
    {"temperature_outlet", "degC", "outlet temperature of flowing oil"},
};
}    // namespace of_fix_heat

// ---- fix bearing/grains: energies since the start of the run
namespace of_fix_grains {
enum { CONTACTS, WORK, DISSIPATED, STORED, KINETIC, MX, MY, MZ, N };
const Column list[N] = {
    {"contacts", "", "number of contacts of grains with each other and with walls",
     raceway::has_none, as_whole},
    {"work", "J", "work done by the walls on the grains, which a shaft loses"},
    {"dissipated", "J", "energy dissipated in contacts of the grains"},
    {"stored", "J", "increase of the kinetic energy and of the energy in contact springs"},
    {"kinetic", "J", "total kinetic energy of the grains, including spin"},
    {"mx", "kg m",
     "increase of the sum of mass times x; multiplied by gravity, this is the work of gravity"},
    {"my", "kg m", "increase of the sum of mass times y"},
    {"mz", "kg m", "increase of the sum of mass times z"},
};
}    // namespace of_fix_grains

// ---- fix bearing/timestep
namespace of_fix_timestep {
enum { LIMIT, SMALLEST, TIME, WALL, N };
const Column list[N] = {
    {"limit", "s", "current largest stable step of velocity Verlet"},
    {"smallest_limit", "s", "smallest limit since the fix was created"},
    {"time", "s", "simulated time"},
    {"wall", "s", "wall-clock time since the start of the run"},
};
}    // namespace of_fix_timestep

}    // namespace bearing
