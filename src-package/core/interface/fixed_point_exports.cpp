// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the starting points of Anderson acceleration (fixed_point.h).
#include "../numbers/fixed_point.h"
#include "exports.h"

#include <algorithm>

using raceway::FixedPoint;

RECORD(FixedPointNext, double residual, distance, contraction;)

// Computes the next start and the norms from the last `starts` starts and the corresponding values
// of the map, in order. Each of them consists of n numbers.
EXPORT(void, fixed_point,
       (int starts, int n, double reach, const double *x, const double *g, const double *weights,
        double *next, FixedPointNext *out))
{
  FixedPoint::Settings set;
  set.reach = reach;
  FixedPoint map(set, {weights, weights + n});
  for (int k = 0; k < starts; ++k) {
    const long at = static_cast<long>(k) * n;
    map.add({x + at, x + at + n}, {g + at, g + at + n});
  }
  FixedPoint copy;    // the copy is unpacked in the same way as after a restart
  copy.unpack(map.packed());
  const FixedPoint::Next to = map.next();
  std::copy(to.start.begin(), to.start.end(), next);
  *out = {to.residual, to.distance, copy.contraction()};
}
