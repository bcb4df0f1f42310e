// SPDX-License-Identifier: GPL-2.0-or-later
// Settings of fix bearing/circuit: the outer circuit, its voltage, breakdown and leak.
#pragma once

#include "../electric/film_network.h"
#include "../electric/waveform.h"
#include "arguments.h"

namespace bearing {

struct CircuitSettings {
  enum Outer { floating, source, motor } outer = floating;
  double start = 0.0;                               // V, initial voltage of a floating inner ring
  double resistance = 0.0;                          // ohm, of a source
  double winding_rotor = 0.0, rotor_frame = 0.0;    // F, of a motor
  double second = 0.0, second_factor = 0.0;         // capacitance of the other bearing, F, or
                                                    // relative to that of this bearing
  double beside = 0.0, stray = 0.0;                 // F
  raceway::Waveform voltage;
  double strength = 0.0, film_floor = 1e-9;    // dielectric strength, V/m, 0 for no breakdown; film
                                               // floor, m
  bool rough = true;                           // reduce the local thickness by 3 sigma
  double resistivity = 0.0;                    // ohm m; 0 for no leak
  double metal = 0.0, metal_share = 0.0;       // resistance of a metallic film, ohm, 0 for none;
                                               // fraction of the load
  double arc = 0.0;                            // ohm, resistance of a failing film; 0 if unknown
  int points = 1;                              // circuit points per sample
  int within = 1;                              // samples per step, of which the last is at the end
                                               // of the step
  std::string events;                          // file to which failures of films are written

  bool breaks_down() const { return strength > 0.0; }
  // Largest breakdown voltage (V) at which a film counts as bridged.
  double bridged() const { return strength * film_floor; }
  // Returns the outer circuit at the given time (s) for a bearing with the capacitance `bearing`
  // (F).
  raceway::OuterPoint at(double time, double bearing) const;
  // Returns the ratio of the coupling capacitance to the total capacitance of the inner ring, or 0
  // if there is no motor.
  double voltage_ratio(const raceway::OuterPoint &, double bearing) const;

  static CircuitSettings read(Arguments &);
};

}    // namespace bearing
