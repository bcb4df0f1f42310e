// SPDX-License-Identifier: GPL-2.0-or-later
// Driving voltage of an outer circuit as a function of time (docs/electric_circuit, Outer circuit).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace raceway {

// A kink or a jump in a driving voltage.
struct Edge {
  double time, before, after;    // s, V, V
};

struct Waveform {
  enum Kind { constant, sine, common_mode, table } kind = constant;
  double voltage = 0.0;                      // V, constant voltage, amplitude, or DC link voltage
  double frequency = 0.0, phase = 0.0;       // Hz, rad, for a sine or for the phases of an inverter
  double carrier = 0.0, modulation = 0.0;    // carrier frequency, Hz; modulation index, from 0 to 1
  std::vector<double> times, voltages;       // times (s) in ascending order and voltages (V), which
                                             // are interpolated linearly

  // Returns the shortest period, s. It is infinite if the waveform does not limit the step.
  double shortest() const
  {
    if (kind == sine) return 1.0 / frequency;
    return kind == common_mode ? 1.0 / carrier : std::numeric_limits<double>::infinity();
  }

  // Returns false if a leg could switch twice between two peaks of the triangle wave.
  bool carrier_fits() const { return carrier >= 2.0 * frequency; }

  // Returns the voltage at time t (s), V.
  double at(double t) const
  {
    if (kind == sine) return voltage * std::sin(turn * frequency * t + phase);
    if (kind == common_mode) return mean(legs_up(t));
    return kind == table ? between(t) : voltage;
  }

  // Returns the edges after `from` and up to `to` (s), in order. There is one for each row of a
  // table and one for each time an inverter leg switches. Legs that switch at the same time do so
  // one after another.
  std::vector<Edge> edges(double from, double to) const
  {
    std::vector<Edge> found;
    if (kind == table)
      for (size_t k = 0; k < times.size(); ++k)
        if (times[k] > from && times[k] <= to)
          found.push_back({times[k], voltages[k], voltages[k]});
    if (kind != common_mode) return found;
    std::vector<std::pair<double, int>> switched;    // time, change in the number of legs at plus
                                                     // half the link voltage
    for (int leg = 0; leg < 3; ++leg)
      for (double lo = from; lo < to;) {
        double hi = std::fmin(to, 0.5 * (std::floor(2.0 * carrier * lo) + 1.0) / carrier);
        if (!(hi > lo)) hi = to;
        const bool was = up(leg, lo);
        if (up(leg, hi) != was) switched.push_back({instant(leg, lo, hi), was ? -1 : 1});
        lo = hi;
      }
    std::stable_sort(switched.begin(), switched.end(),
                     [](const auto &a, const auto &b) { return a.first < b.first; });
    int legs = legs_up(from);
    for (const auto &[time, more] : switched) {
      found.push_back({time, mean(legs), mean(legs + more)});
      legs += more;
    }
    return found;
  }

 private:
  static constexpr double turn = 2.0 * 3.14159265358979323846;

  // Returns true if a leg is at plus half the link voltage, i.e. if its sine is at or above a
  // triangle wave that starts at +1; otherwise the leg is at minus half the link voltage.
  bool up(int leg, double t) const
  {
    const double cycles = carrier * t;
    const double triangle = 4.0 * std::abs(cycles - std::floor(cycles) - 0.5) - 1.0;
    return modulation * std::sin(turn * (frequency * t - leg / 3.0)) >= triangle;
  }
  int legs_up(double t) const { return up(0, t) + up(1, t) + up(2, t); }
  double mean(int legs) const { return voltage * (legs / 3.0 - 0.5); }

  // Finds, by bisection, the first time after `lo` at which a leg has the state that it has at
  // `hi`.
  double instant(int leg, double lo, double hi) const
  {
    const bool was = up(leg, lo);
    for (;;) {
      const double middle = lo + 0.5 * (hi - lo);
      if (!(middle > lo && middle < hi)) return hi;
      (up(leg, middle) == was ? lo : hi) = middle;
    }
  }

  // Interpolates the table. The voltage is constant before the first and after the last time.
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
