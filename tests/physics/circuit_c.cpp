// SPDX-License-Identifier: GPL-2.0-or-later
// The circuit of a bearing, for test_physics_circuit.py.
#include "../../src-package/core/exports.h"
#include "../../src-package/physics/circuit.h"
#include "../../src-package/physics/impedance.h"
#include "../../src-package/physics/waveform.h"

using namespace raceway;

RECORD(CircuitEnd, double source_work, mechanical_work, leak_heat, resistor_heat, discharge_energy,
       stored_energy, discharges, failures, charge_error, energy_error, lost;)

// Arrays of films are by point, side, ball; of the outer circuit by point: beside, coupling,
// conductance, driving. Fills bearing and balls by point, and rows of at most `most` failures:
// point, ball, side, film voltage, bearing voltage, that after, film energy, energy.
EXPORT(int, circuit,
       (int points, int balls, const double *time, const double *capacitance,
        const double *conductance, const double *limit, const double *outer, double start,
        double *bearing, double *ball, double *threshold, double *current, int most,
        double *failures, CircuitEnd *out))
{
  CircuitState s;
  int count = 0;
  for (int p = 0; p < points; ++p) {
    BearingFilms films(balls);
    for (int k = 0; k < balls; ++k) {
      const int inner = 2 * p * balls + k, outer_film = inner + balls;
      films[k].inner = {capacitance[inner], conductance[inner], limit[inner]};
      films[k].outer = {capacitance[outer_film], conductance[outer_film], limit[outer_film]};
    }
    const OuterPoint at = {outer[4 * p], outer[4 * p + 1], outer[4 * p + 2], outer[4 * p + 3]};
    const auto failed = [&](const FilmFailure &f) {
      const double row[] = {double(p),      double(f.ball), double(f.at_outer),
                            f.film_voltage, f.ring_voltage, f.ring_voltage_after,
                            f.film_energy,  f.energy};
      if (count < most)
        for (int j = 0; j < 8; ++j) failures[8 * count + j] = row[j];
      ++count;
    };
    if (p == 0) begin_circuit(s, films, at, start, failed);
    else advance_circuit(s, films, at, time[p] - time[p - 1], failed);
    bearing[p] = s.voltage.ring;
    for (int k = 0; k < balls; ++k) ball[p * balls + k] = s.voltage.ball[k];
    threshold[p] = threshold_voltage(films);
    current[p] = s.account.current;
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

// kind as in Waveform, v the numbers of that kind.
EXPORT(void, waveform,
       (int kind, const double *v, int rows, const double *times, const double *voltages, int n,
        const double *at, double *out))
{
  Waveform w;
  w.kind = Waveform::Kind(kind);
  w.voltage = v[0];
  w.frequency = v[1];
  w.phase = v[2];
  w.carrier = v[3];
  w.modulation = v[4];
  w.times.assign(times, times + rows);
  w.voltages.assign(voltages, voltages + rows);
  for (int k = 0; k < n; ++k) out[k] = w.at(at[k]);
}

EXPORT(double, film_limit, (double thickness, double strength, double less, double floor))
{
  return raceway::film_limit(thickness, strength, less, floor);
}

// Modulus (ohm) and phase (rad) at omega (rad/s) of balls with these capacitances (F) and
// conductances (S), by ball: inner, outer; then C and R read back from them.
EXPORT(void, impedance,
       (int balls, const double *capacitance, const double *conductance, double omega,
        double out[4]))
{
  BearingFilms films(balls);
  for (int k = 0; k < 2 * balls; ++k) {
    CircuitFilm &f = k % 2 ? films[k / 2].outer : films[k / 2].inner;
    f.capacitance = capacitance[k];
    f.conductance = conductance[k];
  }
  const Complex z = 1.0 / admittance(films, omega);
  out[0] = std::abs(z);
  out[1] = std::arg(z);
  out[2] = capacitance_of(z, omega);
  out[3] = resistance_of(z);
}

// V, of films with these thicknesses (m) and capacitances (F), by ball: inner, outer.
EXPORT(double, threshold,
       (int balls, const double *thickness, const double *capacitance, double strength,
        double roughness))
{
  BearingFilms films(balls);
  for (int k = 0; k < 2 * balls; ++k) {
    CircuitFilm &f = k % 2 ? films[k / 2].outer : films[k / 2].inner;
    f.capacitance = capacitance[k];
    f.limit = raceway::film_limit(thickness[k], strength, film_peaks * roughness, 0.0);
  }
  return threshold_voltage(films);
}
