// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the starting points of Anderson acceleration (fixed_point.h) and the multipliers of a map
// (multipliers.h).
#include "../numbers/fixed_point.h"
#include "../numbers/number_list.h"
#include "exports.h"

#include <algorithm>

using raceway::FixedPoint;

RECORD(FixedPointNext, double residual, distance, contraction;)

static FixedPoint filled(int starts, int n, const FixedPoint::Settings &set, const double *x,
                         const double *g, const double *weights)
{
  FixedPoint map(set, {weights, weights + n});
  for (int k = 0; k < starts; ++k) {
    const long at = static_cast<long>(k) * n;
    map.add({x + at, x + at + n}, {g + at, g + at + n});
  }
  return map;
}

// Computes the next start and the norms from the last `starts` starts and the corresponding values
// of the map, in order. Each of them consists of n numbers.
EXPORT(void, fixed_point,
       (int starts, int n, double reach, const double *x, const double *g, const double *weights,
        double *next, FixedPointNext *out))
{
  FixedPoint::Settings set;
  set.reach = reach;
  FixedPoint map = filled(starts, n, set, x, g, weights), copy;
  bearing::NumberWriter kept;    // the copy is made in the same way as after a restart
  map.keep(kept);
  bearing::NumberReader list(kept.numbers().data());
  copy.keep(list);
  const FixedPoint::Next to = map.next();
  std::copy(to.start.begin(), to.start.end(), next);
  *out = {to.residual, to.distance, copy.contraction()};
}

// Computes the multipliers of a map from its last `starts` values, at most four of them, and their
// errors, and returns their number. The values have errors of the size `noise`. `kind` is the sum
// of 1 (stable), 2 (unstable) and 4 (whirls).
EXPORT(int, multipliers,
       (int starts, int n, double noise, const double *x, const double *g, const double *weights,
        double *real, double *imaginary, double *error, int *kind))
{
  FixedPoint::Settings set;
  set.noise = noise;
  const auto all = filled(starts, n, set, x, g, weights).multipliers();
  for (size_t k = 0; k < all.size(); ++k) {
    real[k] = all[k].value.real();
    imaginary[k] = all[k].value.imag();
    error[k] = all[k].error;
    kind[k] = all[k].stable() + 2 * all[k].unstable() + 4 * all[k].whirls();
  }
  return static_cast<int>(all.size());
}
