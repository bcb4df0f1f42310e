// SPDX-License-Identifier: GPL-2.0-or-later
// Frictionless contact of cage parts, treated as spheres: a Hertz spring with critical damping
// (docs/theory, Friction).
#pragma once

#include "../numbers/lane.h"

namespace raceway {

template <class T> struct DampedHertzT {
  T stiffness = T();    // N/m, dF/d(overlap) of the spring alone
  T damping = T();      // N s/m
  T growth = T();       // N/m, derivative of the force with respect to the overlap, including the
                        // damping force
  T force = T();        // N, >= 0 (no adhesion)
};
using DampedHertz = DampedHertzT<double>;

// Computes the force K overlap^1.5 plus critical damping 2 sqrt(k m), with the reduced mass m and
// the current stiffness k. Preconditions: overlap >= 0 (m), K >= 0 (N/m^1.5), m > 0 (kg).
// overlap_rate is in m/s; it is positive while the bodies approach each other.
template <class T>
RACEWAY_INLINE DampedHertzT<T> damped_hertz(double K, const T &overlap, const T &overlap_rate,
                                            const T &m)
{
  DampedHertzT<T> h;
  const T root = square_root(overlap);
  h.stiffness = 1.5 * K * root;
  h.damping = 2.0 * square_root(T(h.stiffness * m));
  const T f = K * overlap * root + h.damping * overlap_rate;
  const T closing = where(overlap_rate > 0.0, overlap_rate, 0.0);
  h.growth = h.stiffness + where(overlap > 0.0, T(0.25 * h.damping * closing / overlap), 0.0);
  h.force = where(f > 0.0, f, 0.0);
  return h;
}

// Returns the dissipated power, W. While the bodies separate faster than the spring relaxes, there
// is no contact force, and the energy of the spring is dissipated.
template <class T>
RACEWAY_INLINE T damping_loss(const DampedHertzT<T> &h, const T &overlap, const T &overlap_rate)
{
  return (h.force - h.stiffness * overlap / 1.5) * overlap_rate;
}

}    // namespace raceway
