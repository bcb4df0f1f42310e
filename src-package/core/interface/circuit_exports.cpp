// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the circuit of a bearing with given films (circuit.h), its discharges (film_breakdown.h)
// and its driving voltages (waveform.h).
#include "../electric/circuit.h"
#include "../electric/waveform.h"
#include "exports.h"

using namespace raceway;

// Point at which a charged ball has no film, and the index of that ball. Both are -1 if there is
// none.
RECORD(CircuitEnd, double point, ball;)

namespace {
// Returns the films at one point. The arrays are indexed by side and ball.
BearingFilms films_of(int balls, const double *capacitance, const double *limit)
{
  BearingFilms films(balls);
  for (int k = 0; k < balls; ++k) {
    const int other = k + balls;
    films[k].inner.capacitance = capacitance[k];
    films[k].outer.capacitance = capacitance[other];
    if (limit) films[k].inner.limit = limit[k];
    if (limit) films[k].outer.limit = limit[other];
  }
  return films;
}

NodeValues nodes_of(int balls, const double *ball, double ring)
{
  return {std::vector<double>(ball, ball + balls), ring};
}

void put(const NodeValues &v, double *ball, double *ring)
{
  std::copy(v.ball.begin(), v.ball.end(), ball);
  *ring = v.ring;
}

// number of columns in a row of failures
constexpr int columns = 10;
void put(const FilmFailure &f, double time, double discharge, double *row)
{
  const double numbers[columns] = {
      time,           discharge,      double(f.order),      double(f.at_outer), double(f.ball),
      f.film_voltage, f.ring_voltage, f.ring_voltage_after, f.film_energy,      f.energy};
  std::copy(numbers, numbers + columns, row);
}
}    // namespace

// Solves the circuit. The arrays of films are indexed by point, side and ball. A film fails at
// film_limit(thickness, strength, less, floor); if the strength is 0, it never fails. The outer
// circuit has a parallel capacitance (`beside` plus `factor` times the bearing's own capacitance),
// a coupling and a conductance. The driving voltage is given at each point, and its edges are given
// as rows in order of time (time, voltage before, voltage after). Films and voltage vary linearly
// between points. Each row of failures (at most `most` rows) contains time, discharge, order, side,
// ball, film voltage, bearing voltage, bearing voltage after the discharge, film energy and energy.
// The circuit ends at a point where a charged ball has no film. Returns the number of failures.
EXPORT(int, bearing_circuit,
       (int points, int balls, const double *time, const double *capacitance,
        const double *conductance, const double *thickness, double strength, double less,
        double floor, double beside, double factor, double coupling, double source,
        const double *driving, int edge_count, const double *edges, double start, double *ball,
        double *bearing, double *ball_charge, double *current, double *source_work,
        double *mechanical_work, double *leak_heat, double *resistor_heat, double *discharge_energy,
        double *stored_energy, double *charge_error, double *energy_error, int most,
        double *failures, CircuitEnd *out))
{
  CircuitState s;
  int count = 0, next = 0;
  *out = {-1.0, -1.0};
  // returns the circuit at the time that lies a fraction `back` of a step before point p
  const auto point = [&](int p, double back, double volts) {
    const auto film = [&](int k) {
      const auto mix = [&](const double *values) {
        const double *at = values + 2 * p * balls + k;
        return back > 0.0 ? *at - back * (*at - at[-2 * balls]) : *at;
      };
      CircuitFilm f{mix(capacitance), mix(conductance)};
      if (strength > 0.0 && f.capacitance > 0.0)
        f.limit = film_limit(mix(thickness), strength, less, floor);
      return f;
    };
    BearingFilms films(balls);
    for (int k = 0; k < balls; ++k) films[k] = {film(k), film(balls + k)};
    const double all = beside + factor * bearing_capacitance(films);
    return CircuitPoint{std::move(films), {all, coupling, source, volts}};
  };
  double now = time[0];
  const auto failed = [&](const FilmFailure &f) {
    if (count < most) put(f, now, s.account.discharges + 1.0, failures + columns * count);
    ++count;
  };
  for (int p = 0; p < points; ++p) {
    if (p == 0) {
      begin_circuit(s, point(0, 0.0, driving[0]), start, failed);
    } else {
      std::vector<Edge> within;
      for (; next < edge_count && edges[3 * next] <= time[p]; ++next)
        if (edges[3 * next] > time[p - 1])
          within.push_back({edges[3 * next], edges[3 * next + 1], edges[3 * next + 2]});
      const auto at = [&](double t) {
        now = t;
        return point(p, (time[p] - t) / (time[p] - time[p - 1]), driving[p]);
      };
      advance_circuit(s, time[p - 1], time[p], within, at, failed);
    }
    put(s.voltage, ball + p * balls, bearing + p);
    std::copy(s.charge.ball.begin(), s.charge.ball.end(), ball_charge + p * balls);
    const CircuitAccount &a = s.account;
    current[p] = a.current;
    source_work[p] = a.source_work;
    mechanical_work[p] = a.mechanical_work;
    leak_heat[p] = a.leak_heat;
    resistor_heat[p] = a.resistor_heat;
    discharge_energy[p] = a.discharge_energy;
    stored_energy[p] = raceway::stored_energy(s.films, s.outer, s.voltage);
    charge_error[p] = a.charge_error;
    energy_error[p] = a.energy_error;
    const int lost = charged_without_film(s);
    if (lost >= 0) {
      *out = {double(p), double(lost)};
      break;
    }
  }
  return count;
}

// Computes the discharge at a single point in place. The rows of failures are as described above.
// Returns the number of failures.
EXPORT(int, film_discharge,
       (int balls, const double *capacitance, const double *limit, double beside, double coupling,
        double driving, double *ball_charge, double *ring_charge, double *ball, double *ring,
        double *work, double *failures))
{
  int count = 0;
  const OuterPoint outer = {beside, coupling, 0.0, driving};
  NodeValues charge = nodes_of(balls, ball_charge, *ring_charge);
  NodeValues voltage = nodes_of(balls, ball, *ring);
  *work = discharge(films_of(balls, capacitance, limit), outer, charge, voltage,
                    [&](const FilmFailure &f) { put(f, 0.0, 1.0, failures + columns * count++); });
  put(charge, ball_charge, ring_charge);
  put(voltage, ball, ring);
  return count;
}

// Computes the voltages if the broken films (those whose entry, indexed by side and ball, is not 0)
// are conductors.
EXPORT(void, film_redistribution,
       (int balls, const double *capacitance, double beside, double coupling, double driving,
        const double *ball_charge, double ring_charge, const int *broken, double *ball,
        double *ring))
{
  std::vector<Broken> which(balls);
  for (int k = 0; k < balls; ++k) which[k] = {broken[k] != 0, broken[balls + k] != 0};
  NodeValues voltage = nodes_of(balls, ball_charge, 0.0);
  redistribute(films_of(balls, capacitance, nullptr), {beside, coupling, 0.0, driving},
               nodes_of(balls, ball_charge, ring_charge), which, voltage);
  put(voltage, ball, ring);
}

// Computes the voltage (V) between the rings at which the first film fails, at each point. It is 0
// if the limit of that film is at most `bridged` (V).
EXPORT(void, threshold_voltages,
       (int points, int balls, const double *capacitance, const double *limit, double bridged,
        double *out))
{
  for (int p = 0; p < points; ++p)
    out[p] = threshold_voltage(films_of(balls, capacitance + 2 * p * balls, limit + 2 * p * balls),
                               bridged);
}

FORMULA(double, film_limit, (double thickness, double strength, double less, double floor))
{
  return film_limit(thickness, strength, less, floor);
}

FORMULA(double, local_thickness, (double thickness, double less, double floor))
{
  return local_thickness(thickness, less, floor);
}

// Writes rows of time, voltage before and voltage after, in order of time. There is one row for
// each time an inverter leg switches between the two times, but at most `most` rows are written.
// Returns the number of rows.
EXPORT(int, inverter_edges,
       (int points, const double *time, double voltage, double frequency, double carrier,
        double modulation, int most, double *out))
{
  const Waveform w = {Waveform::common_mode, voltage, frequency, 0.0, carrier, modulation, {}, {}};
  int count = 0;
  for (int p = 1; p < points; ++p)
    for (const Edge &e : w.edges(time[p - 1], time[p])) {
      if (count < most) std::copy_n(&e.time, 3, out + 3 * count);
      ++count;
    }
  return count;
}

// `kind` is 0 for constant, 1 for sine and 2 for common mode.
FORMULA(double, waveform,
        (double time, int kind, double voltage, double frequency, double phase, double carrier,
         double modulation))
{
  return Waveform{Waveform::Kind(kind), voltage, frequency, phase, carrier, modulation, {}, {}}.at(
      time);
}
