// SPDX-License-Identifier: GPL-2.0-or-later
// Driving voltage of an outer circuit over time (docs/electric_circuit, Outer circuit).
#ifndef RACEWAY_WAVEFORM_H
#define RACEWAY_WAVEFORM_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace raceway {

struct Waveform {
  enum Kind { constant, sine, common_mode, table } kind = constant;
  double voltage = 0.0;                      // V: constant, amplitude, or DC link voltage
  double frequency = 0.0, phase = 0.0;       // Hz, rad: of a sine, of the phases of an inverter
  double carrier = 0.0, modulation = 0.0;    // Hz; 0 to 1
  std::vector<double> times, voltages;       // s, rising; V: straight lines between

  // Shortest period, s; infinite if it does not limit the step.
  double shortest() const
  {
    if (kind == sine) return 1.0 / frequency;
    return kind == common_mode ? 1.0 / carrier : std::numeric_limits<double>::infinity();
  }

  // Voltage at time t (s), V.
  double at(double t) const
  {
    const double turn = 2.0 * 3.14159265358979323846;
    if (kind == sine) return voltage * std::sin(turn * frequency * t + phase);
    if (kind == common_mode) return inverter(t, turn);
    return kind == table ? between(t) : voltage;
  }

 private:
  // Mean of three legs. Each is at half the link voltage while its sine is not below a triangle
  // that starts at +1, otherwise at minus half.
  double inverter(double t, double turn) const
  {
    const double cycles = carrier * t;
    const double triangle = 4.0 * std::abs(cycles - std::floor(cycles) - 0.5) - 1.0;
    int on = 0;
    for (int leg = 0; leg < 3; ++leg)
      on += modulation * std::sin(turn * (frequency * t - leg / 3.0)) >= triangle;
    return voltage * (on / 3.0 - 0.5);
  }

  // Constant before the first and after the last time.
  double between(double t) const
  {
    const size_t k = std::upper_bound(times.begin(), times.end(), t) - times.begin();
    if (k == 0) return voltages.front();
    if (k == times.size()) return voltages.back();
    const double share = (t - times[k - 1]) / (times[k] - times[k - 1]);
    return voltages[k - 1] + share * (voltages[k] - voltages[k - 1]);
  }
};

}    // namespace raceway

#endif
