// SPDX-License-Identifier: GPL-2.0-or-later
// The circuit of a bearing over given films (circuit.h), its discharges (film_breakdown.h) and its
// driving voltages (waveform.h).
#include "../electric/circuit.h"
#include "../electric/impedance.h"
#include "../electric/waveform.h"
#include "exports.h"

#include <cmath>

using namespace raceway;

RECORD(CircuitEnd, double source_work, mechanical_work, leak_heat, resistor_heat, discharge_energy,
       stored_energy, discharges, failures, charge_error, energy_error, lost;)

namespace {
// Films of one point; arrays are by side and ball.
BearingFilms films_of(int balls, const double *capacitance, const double *conductance,
                      const double *limit)
{
  BearingFilms films(balls);
  for (int k = 0; k < balls; ++k) {
    const int other = k + balls;
    films[k].inner.capacitance = capacitance[k];
    films[k].outer.capacitance = capacitance[other];
    if (conductance) films[k].inner.conductance = conductance[k];
    if (conductance) films[k].outer.conductance = conductance[other];
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

// Columns in a row of failures, and of the account.
constexpr int columns = 8, terms = 8;
void put(const FilmFailure &f, int point, double *row)
{
  const double numbers[columns] = {
      double(point),  double(f.at_outer),   double(f.ball), f.film_voltage,
      f.ring_voltage, f.ring_voltage_after, f.film_energy,  f.energy};
  std::copy(numbers, numbers + columns, row);
}
}    // namespace

// Films are by point, side, ball; the outer circuit by point: parallel capacitance, coupling,
// conductance, driving voltage. Voltages `before` exclude the discharge of their point. Rows of
// failures, at most `most`: point, side, ball, film voltage, bearing voltage, bearing voltage
// after, film energy, energy. Rows of the account, by point: stored energy; since the start source
// work, mechanical work, leak heat, resistor heat, discharge energy; errors of energy and charge of
// the step. Returns the number of failures.
EXPORT(int, bearing_circuit,
       (int points, int balls, const double *time, const double *capacitance,
        const double *conductance, const double *limit, const double *outer, double start,
        double *ball, double *bearing, double *ball_before, double *bearing_before,
        double *ball_charge, double *ring_charge, double *leaked, double *supplied,
        double *discharge_work, double *current, double *account, int most, double *failures,
        CircuitEnd *out))
{
  CircuitState s;
  int count = 0;
  for (int p = 0; p < points; ++p) {
    const int at = p * balls, films_at = 2 * at;
    const BearingFilms films =
        films_of(balls, capacitance + films_at, conductance + films_at, limit + films_at);
    const OuterPoint circuit = {outer[4 * p], outer[4 * p + 1], outer[4 * p + 2], outer[4 * p + 3]};
    const auto failed = [&](const FilmFailure &f) {
      if (count < most) put(f, p, failures + columns * count);
      ++count;
    };
    if (p == 0) begin_circuit(s, films, circuit, start, failed);
    else advance_circuit(s, films, circuit, time[p] - time[p - 1], failed);
    put(s.voltage, ball + at, bearing + p);
    put(s.before, ball_before + at, bearing_before + p);
    put(s.charge, ball_charge + at, ring_charge + p);
    std::copy(s.moved.inner.begin(), s.moved.inner.end(), leaked + films_at);
    std::copy(s.moved.outer.begin(), s.moved.outer.end(), leaked + films_at + balls);
    supplied[p] = s.moved.supplied;
    discharge_work[p] = s.discharge_work;
    const CircuitAccount &a = s.account;
    current[p] = p == 0 ? NAN : a.current;
    const double row[terms] = {stored_energy(s.films, s.outer, s.voltage),
                               a.source_work,
                               a.mechanical_work,
                               a.leak_heat,
                               a.resistor_heat,
                               a.discharge_energy,
                               s.energy_error,
                               s.charge_error};
    std::copy(row, row + terms, account + terms * p);
  }
  const CircuitAccount &a = s.account;
  *out = {a.source_work,
          a.mechanical_work,
          a.leak_heat,
          a.resistor_heat,
          a.discharge_energy,
          stored_energy(s.films, s.outer, s.voltage),
          a.discharges,
          a.failures,
          a.charge_error,
          a.energy_error,
          double(charged_without_film(s))};
  return count;
}

// A single point: its discharge in place, and its failures as above. Returns their number.
EXPORT(int, film_discharge,
       (int balls, const double *capacitance, const double *limit, double beside, double coupling,
        double driving, double *ball_charge, double *ring_charge, double *ball, double *ring,
        double *work, double *failures))
{
  int count = 0;
  const OuterPoint outer = {beside, coupling, 0.0, driving};
  NodeValues charge = nodes_of(balls, ball_charge, *ring_charge);
  NodeValues voltage = nodes_of(balls, ball, *ring);
  *work = discharge(films_of(balls, capacitance, nullptr, limit), outer, charge, voltage,
                    [&](const FilmFailure &f) { put(f, 0, failures + columns * count++); });
  put(charge, ball_charge, ring_charge);
  put(voltage, ball, ring);
  return count;
}

// Voltages with the broken films (by side, ball; not 0) as conductors.
EXPORT(void, film_redistribution,
       (int balls, const double *capacitance, double beside, double coupling, double driving,
        const double *ball_charge, double ring_charge, const int *broken, double *ball,
        double *ring))
{
  std::vector<Broken> which(balls);
  for (int k = 0; k < balls; ++k) which[k] = {broken[k] != 0, broken[balls + k] != 0};
  NodeValues voltage = nodes_of(balls, ball_charge, 0.0);
  redistribute(films_of(balls, capacitance, nullptr, nullptr), {beside, coupling, 0.0, driving},
               nodes_of(balls, ball_charge, ring_charge), which, voltage);
  put(voltage, ball, ring);
}

// Voltage between the rings at which the first film fails, V, by point
EXPORT(void, threshold_voltages,
       (int points, int balls, const double *capacitance, const double *limit, double *out))
{
  for (int p = 0; p < points; ++p)
    out[p] = threshold_voltage(
        films_of(balls, capacitance + 2 * p * balls, nullptr, limit + 2 * p * balls));
}

RECORD(Impedance, double real, imaginary;)
namespace {
constexpr double turn = 2.0 * 3.14159265358979323846;
Impedance parts(const Complex &z) { return {z.real(), z.imag()}; }
}    // namespace

// ohm, of one film at a frequency in Hz
FORMULA(Impedance, film_impedance, (double capacitance, double conductance, double frequency))
{
  CircuitFilm f;
  f.capacitance = capacitance;
  f.conductance = conductance;
  return parts(1.0 / admittance(f, turn * frequency));
}

FORMULA(double, capacitance_of_impedance, (double real, double imaginary, double frequency))
{
  return capacitance_of({real, imaginary}, turn * frequency);
}

FORMULA(double, resistance_of_impedance, (double real, double imaginary))
{
  return resistance_of({real, imaginary});
}

// S, by point; films are by point, side, ball
EXPORT(void, bearing_admittances,
       (int points, int balls, const double *frequency, const double *capacitance,
        const double *conductance, double *real, double *imaginary))
{
  for (int p = 0; p < points; ++p) {
    const int at = 2 * p * balls;
    const BearingFilms films = films_of(balls, capacitance + at, conductance + at, nullptr);
    const Impedance found = parts(admittance(films, turn * frequency[p]));
    real[p] = found.real;
    imaginary[p] = found.imaginary;
  }
}

FORMULA(double, film_limit, (double thickness, double strength, double less, double floor))
{
  return film_limit(thickness, strength, less, floor);
}

FORMULA(double, local_thickness, (double thickness, double less, double floor))
{
  return local_thickness(thickness, less, floor);
}

// kind: 0 constant, 1 sine, 2 common mode
FORMULA(double, waveform,
        (double time, int kind, double voltage, double frequency, double phase, double carrier,
         double modulation))
{
  Waveform w;
  w.kind = Waveform::Kind(kind);
  w.voltage = voltage;
  w.frequency = frequency;
  w.phase = phase;
  w.carrier = carrier;
  w.modulation = modulation;
  return w.at(time);
}
