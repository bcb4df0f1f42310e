// SPDX-License-Identifier: GPL-2.0-or-later
// Advances a bearing in an outer circuit step by step and computes the energy balance of the
// circuit (docs/electric_circuit, Energy).
#pragma once

#include "film_breakdown.h"
#include "waveform.h"

namespace raceway {

// Totals since the start of the run (J, C), and the current in the last step. All members are plain
// doubles, because they are stored in restart files.
struct CircuitAccount {
  double source_work = 0.0, mechanical_work = 0.0, leak_heat = 0.0, resistor_heat = 0.0;
  double discharge_energy = 0.0;
  double discharges = 0.0, failures = 0.0;          // counts
  double film_charge = 0.0;                         // largest charge on a film at full voltage
  double charge_error = 0.0, energy_error = 0.0;    // largest charge error of a node; largest
                                                    // energy error of a step
  double current = 0.0;    // A, mean current into the films of the inner ring in the last step
};

// Films and outer circuit at a point in time.
struct CircuitPoint {
  BearingFilms films;
  OuterPoint outer;
};

// State of a circuit at a point in time, after the discharge at that point.
struct CircuitState : CircuitPoint {
  NodeValues charge, voltage;
  CircuitAccount account;
};

namespace circuit_detail {

inline double largest_charge_error(const CircuitState &s)
{
  double most = std::abs(ring_charge(s.films, s.outer, s.voltage) - s.charge.ring);
  for (size_t k = 0; k < s.films.size(); ++k) {
    const double u = s.voltage.ball[k];
    const double by_voltage =
        s.films[k].outer.capacitance * u - s.films[k].inner.capacitance * (s.voltage.ring - u);
    most = std::fmax(most, std::abs(by_voltage - s.charge.ball[k]));
  }
  return most;
}

inline double inner_film_charge(const BearingFilms &films, const NodeValues &v)
{
  double sum = 0.0;
  for (size_t k = 0; k < films.size(); ++k)
    sum += films[k].inner.capacitance * (v.ring - v.ball[k]);
  return sum;
}

inline double largest_film_charge(const CircuitState &s)
{
  double most = 0.0;
  for (const BallFilms &f : s.films)
    most = std::fmax(most, std::fmax(f.inner.capacitance, f.outer.capacitance));
  return most * std::abs(s.voltage.ring);
}

// Computes the discharge at the current point of `s` and adds it to the account. `before` is the
// stored energy before the discharge, including all energy supplied since then.
template <class Failed> void settle(CircuitState &s, double before, Failed &&failed)
{
  CircuitAccount &a = s.account;
  a.film_charge = std::fmax(a.film_charge, largest_film_charge(s));
  double heat = 0.0;
  int count = 0;
  const double work = discharge(s.films, s.outer, s.charge, s.voltage, [&](const FilmFailure &f) {
    heat += f.energy;
    ++count;
    failed(f);
  });
  a.discharges += count > 0;
  a.failures += count;
  a.discharge_energy += heat;
  a.source_work += work;
  const double lacks = before + work - heat - stored_energy(s.films, s.outer, s.voltage);
  a.energy_error = std::fmax(a.energy_error, std::abs(lacks));
  a.charge_error = std::fmax(a.charge_error, largest_charge_error(s));
}

// Advances to a point `length` (s) later; returns the charge (C) that entered the films at the
// inner ring.
template <class Failed>
double step_circuit(CircuitState &s, const CircuitPoint &to, double length, Failed &&failed)
{
  const BearingFilms &films = to.films;
  const OuterPoint &outer = to.outer;
  const NodeValues v0 = s.voltage;
  const double stored = stored_energy(s.films, s.outer, v0), charge = s.charge.ring;
  double flown = -inner_film_charge(s.films, v0);
  StepCharges moved;
  network_step(s.films, films, s.outer, outer, length, s.charge, s.voltage, moved);
  const NodeValues &v1 = s.voltage;
  if (outer.stiff()) {
    s.charge.ring = ring_charge(films, outer, v1);
    moved.supplied = s.charge.ring - charge;
    for (double q : moved.inner) moved.supplied += q;
  }
  // charge through every element times the mean of the voltages at both ends of the step. For a
  // capacitance, the remainder of the change in energy is the work done by moving its plates
  double plates = v0.ring * v1.ring * (outer.beside - s.outer.beside), leak = 0.0;
  for (size_t k = 0; k < films.size(); ++k) {
    const double in0 = v0.ring - v0.ball[k], in1 = v1.ring - v1.ball[k];
    const double out0 = v0.ball[k], out1 = v1.ball[k];
    plates += in0 * in1 * (films[k].inner.capacitance - s.films[k].inner.capacitance) +
              out0 * out1 * (films[k].outer.capacitance - s.films[k].outer.capacitance);
    leak += 0.5 * ((in0 + in1) * moved.inner[k] + (out0 + out1) * moved.outer[k]);
  }
  const double driving = 0.5 * (s.outer.driving + outer.driving);
  const double coupled = outer.coupling * (outer.driving - s.outer.driving - (v1.ring - v0.ring));
  const double source = driving * (moved.supplied + coupled), mechanical = -0.5 * plates;
  const double resistor =
      outer.stiff() ? 0.0 : (driving - 0.5 * (v0.ring + v1.ring)) * moved.supplied;
  CircuitAccount &a = s.account;
  a.source_work += source;
  a.mechanical_work += mechanical;
  a.leak_heat += leak;
  a.resistor_heat += resistor;
  flown += inner_film_charge(films, v1);
  for (double q : moved.inner) flown += q;
  static_cast<CircuitPoint &>(s) = to;
  settle(s, stored + source + mechanical - leak - resistor, failed);
  return flown;
}

}    // namespace circuit_detail

// Starts at the first point: the balls have no charge, and the inner ring is at the voltage `start`
// (V) unless it is driven by a voltage source. `failed` is called for every FilmFailure, in order.
template <class Failed>
void begin_circuit(CircuitState &s, const CircuitPoint &at, double start, Failed &&failed)
{
  const BearingFilms &films = at.films;
  const OuterPoint &outer = at.outer;
  s = {};
  static_cast<CircuitPoint &>(s) = at;
  s.charge.ball.assign(films.size(), 0.0);
  double capacitance = bearing_capacitance(films) + outer.beside;
  if (!outer.stiff()) capacitance += outer.coupling;
  s.charge.ring = start * capacitance;
  find_voltages(films, outer, 0.0, s.charge, s.voltage);
  if (outer.stiff()) s.charge.ring = ring_charge(films, outer, s.voltage);
  circuit_detail::settle(s, stored_energy(films, outer, s.voltage), failed);
}

// Returns the first ball that has a charge but no film, or -1 if there is none. The voltage of such
// a ball would be unbounded. Rounding residues of a charge do not count.
inline int charged_without_film(const CircuitState &s)
{
  const double rounding = 1e-12 * s.account.film_charge;
  for (size_t k = 0; k < s.films.size(); ++k)
    if (s.films[k].inner.capacitance + s.films[k].outer.capacitance == 0.0 &&
        std::abs(s.charge.ball[k]) > rounding)
      return static_cast<int>(k);
  return -1;
}

// Advances to the next point, from the time `from` to the time `to` (s). The driving voltage is
// linear between the `edges`, which are sorted by time and lie in the interval from `from`
// (excluded) to `to` (included). Films may fail at each edge. `at(time)` returns the CircuitPoint
// at that time.
template <class Edges, class At, class Failed>
void advance_circuit(CircuitState &s, double from, double to, const Edges &edges, At &&at,
                     Failed &&failed)
{
  using circuit_detail::step_circuit;
  double reached = from, flown = 0.0;
  for (const Edge &e : edges) {
    CircuitPoint p = at(e.time);
    p.outer.driving = e.before;
    if (e.time > reached) flown += step_circuit(s, p, e.time - reached, failed);
    p.outer.driving = e.after;
    if (e.after != e.before) flown += step_circuit(s, p, 0.0, failed);
    reached = e.time;
  }
  if (to > reached) flown += step_circuit(s, at(to), to - reached, failed);
  s.account.current = flown / (to - from);
}

}    // namespace raceway
