// SPDX-License-Identifier: GPL-2.0-or-later
// Frictionless sphere-like contact of cage parts: Hertz spring with critical damping (docs/theory, Friction).
#ifndef RACEWAY_DAMPED_HERTZ_H
#define RACEWAY_DAMPED_HERTZ_H

#include <cmath>

namespace raceway {

struct DampedHertz {
  double stiffness = 0.0;    // N/m, dF/d(overlap) of the spring
  double damping = 0.0;      // N s/m
  double force = 0.0;        // N, >= 0 (no adhesion)
};

// K overlap^1.5 with the critical damping 2 sqrt(k m) of the reduced mass m at the present stiffness k.
// Pre-conditions: overlap >= 0 (m), K >= 0 (N/m^1.5), m > 0 (kg); overlap_rate in m/s, > 0 when closing.
inline DampedHertz damped_hertz(double K, double overlap, double overlap_rate, double m)
{
  DampedHertz h;
  const double root = std::sqrt(overlap);
  h.stiffness = 1.5 * K * root;
  h.damping = 2.0 * std::sqrt(h.stiffness * m);
  const double f = K * overlap * root + h.damping * overlap_rate;
  h.force = f > 0.0 ? f : 0.0;
  return h;
}

}    // namespace raceway

#endif
