// SPDX-License-Identifier: GPL-2.0-or-later
// Voltage over time that drives an outer circuit (docs/electric_circuit, Outer circuit).
#ifndef RACEWAY_WAVEFORM_H
#define RACEWAY_WAVEFORM_H

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace raceway {

struct Waveform {
  enum Kind { constant, sine, common_mode, table } kind = constant;
  double voltage = 0.0;                      // V: the constant, an amplitude, that of a link
  double frequency = 0.0, phase = 0.0;       // Hz, rad: of a sine, of the phases of an inverter
  double carrier = 0.0, modulation = 0.0;    // Hz; 0 to 1
  std::vector<double> times, voltages;       // s, rising; V: straight lines between

  // Shortest period, s; infinite where nothing bounds a step.
  double shortest() const
  {
    if (kind == sine) return 1.0 / frequency;
    return kind == common_mode ? 1.0 / carrier : std::numeric_limits<double>::infinity();
  }

  // V at time t (s).
  double at(double t) const
  {
    const double turn = 2.0 * 3.14159265358979323846;
    if (kind == sine) return voltage * std::sin(turn * frequency * t + phase);
    if (kind == common_mode) return inverter(t, turn);
    return kind == table ? between(t) : voltage;
  }

 private:
  // The mean of three legs. Each is at half the link's voltage while its sine is not below a
  // triangle that begins at +1, else at minus that.
  double inverter(double t, double turn) const
  {
    const double cycles = carrier * t;
    const double triangle = 4.0 * std::abs(cycles - std::floor(cycles) - 0.5) - 1.0;
    int on = 0;
    for (int leg = 0; leg < 3; ++leg)
      on += modulation * std::sin(turn * (frequency * t - leg / 3.0)) >= triangle;
    return voltage * (on / 3.0 - 0.5);
  }

  // The ends hold before and after.
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
