// SPDX-License-Identifier: GPL-2.0-or-later
// Impedance of films, balls and a bearing, and the inverse calculation, which evaluates instrument
// readings (docs/electric, Impedance). A film is a capacitor in parallel with its leakage
// resistance: Z = 1/(G + j omega C).
#pragma once

#include "film_network.h"

#include <complex>

namespace raceway {

using Complex = std::complex<double>;

// Returns the admittance of a film, S, at omega (rad/s; 0: direct current).
inline Complex admittance(const CircuitFilm &f, double omega)
{
  return {f.conductance, omega * f.capacitance};
}

// Returns the admittance of a bearing, S. Both films of a ball are in series, and the balls are in
// parallel. A ball with an open film contributes nothing.
inline Complex admittance(const BearingFilms &films, double omega)
{
  Complex sum = 0.0;
  for (const BallFilms &f : films) {
    const Complex in = admittance(f.inner, omega), out = admittance(f.outer, omega);
    if (in != 0.0 && out != 0.0) sum += in * out / (in + out);
  }
  return sum;
}

// Returns the capacitance C (F) from a measured impedance (ohm): -sin(phi)/(omega |Z|), phi = arg
// Z.
inline double capacitance_of(const Complex &z, double omega)
{
  return -z.imag() / (omega * std::norm(z));
}

// Returns the resistance R (ohm) in parallel with that capacitance, |Z|/cos(phi).
inline double resistance_of(const Complex &z) { return std::norm(z) / z.real(); }

}    // namespace raceway
