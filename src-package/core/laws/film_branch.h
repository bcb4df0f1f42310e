// SPDX-License-Identifier: GPL-2.0-or-later
// Film damping of a rolling contact: a spring k_m and a dashpot k_m tau in series, which act in
// parallel with the Hertz spring (docs/tribology, Film damping).
//
//   df/dt = k_m d(overlap)/dt - f/tau,  k_m = 0.44 k h_c/x,  tau = 1.33 b/u
//   k = 1.5 Q/x for the Hertz contact, N/m;  x elastic approach, m;  h_c/x at most 1
// These are fits to the linear response of a steady elastohydrodynamic line contact, applied to the
// contact ellipse.
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

template <class T> struct FilmBranchT {
  T stiffness;    // k_m, N/m
  T rate;         // 1/tau, 1/s; 0 at rest
};

template <class T>
RACEWAY_INLINE FilmBranchT<T> film_branch(const T &k, const T &h_c, const T &compression,
                                          const T &b, const T &speed)
{
  const T thin = where(h_c < compression, T(h_c / compression), 1.0);
  return {0.44 * k * thin, speed / (1.33 * b)};
}

// Coefficients of a step of length dt, during which f becomes `left` f + `slope` d(overlap)/dt. The
// step is exact if the rate is constant. In a stage of an implicit method it is a backward Euler
// step (LawStates).
template <class T> struct BranchStepT {
  T left;     // 1
  T slope;    // N s/m
};
template <class T>
RACEWAY_INLINE BranchStepT<T> branch_step(const FilmBranchT<T> &f, double dt, bool stage)
{
  const T part = dt * f.rate;
  if (stage) {
    const T left = 1.0 / (1.0 + part);
    return {left, f.stiffness * dt * left};
  }
  const T left = exponential(T(-part));
  // (1 - e^-part)/part, computed from a series where the difference would suffer from cancellation
  const T series = 1.0 - part * (0.5 - part * (1.0 / 6 - part * (1.0 / 24 - part * (1.0 / 120))));
  const T mean = where(part > 1e-3, T((1.0 - left) / part), series);
  return {left, f.stiffness * dt * mean};
}

}    // namespace raceway
