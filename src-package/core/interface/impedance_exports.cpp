// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the impedance of films and bearings (impedance.h).
#include "../electric/impedance.h"
#include "exports.h"

using namespace raceway;

RECORD(Impedance, double real, imaginary;)

namespace {
constexpr double turn = 2.0 * 3.14159265358979323846;
Impedance parts(const Complex &z) { return {z.real(), z.imag()}; }
}    // namespace

// Returns the impedance (ohm) of one film at a frequency (Hz).
FORMULA(Impedance, film_impedance, (double capacitance, double conductance, double frequency))
{
  return parts(1.0 / admittance(CircuitFilm{capacitance, conductance}, turn * frequency));
}

FORMULA(double, capacitance_of_impedance, (double real, double imaginary, double frequency))
{
  return capacitance_of({real, imaginary}, turn * frequency);
}

FORMULA(double, resistance_of_impedance, (double real, double imaginary))
{
  return resistance_of({real, imaginary});
}

// Computes the admittance (S) of the bearing at each point. The arrays of films are indexed by
// point, side and ball.
EXPORT(void, bearing_admittances,
       (int points, int balls, const double *frequency, const double *capacitance,
        const double *conductance, double *real, double *imaginary))
{
  for (int p = 0; p < points; ++p) {
    const double *C = capacitance + 2 * p * balls, *G = conductance + 2 * p * balls;
    BearingFilms films(balls);
    for (int k = 0; k < balls; ++k) films[k] = {{C[k], G[k]}, {C[balls + k], G[balls + k]}};
    const Impedance found = parts(admittance(films, turn * frequency[p]));
    real[p] = found.real;
    imaginary[p] = found.imaginary;
  }
}
