// SPDX-License-Identifier: GPL-2.0-or-later
// The impedance of a bearing, for test_physics_circuit.py.
#include "../../src-package/core/electric/impedance.h"
#include "../../src-package/core/interface/exports.h"

using namespace raceway;

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
