// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the settling of a recorded run (settling.h).
#include "../figures/settling.h"
#include "exports.h"

#include <algorithm>

using bearing::Settling;
using bearing::SettlingSample;
using raceway::Vec3;

RECORD(SettlingOfRun, double torque, load, cage_speed, spin_axis;)

// Computes the changes between the last two halves, which consist of `half` samples each. The input
// contains the friction torque, the largest load on each raceway and the cage speed for every
// sample, and the load, the position relative to the bearing's centre and the spin for every sample
// and ball, with z along the bearing's axis. If there are fewer than two halves, the changes are
// infinite.
EXPORT(void, settling,
       (int samples, int balls, int half, const double *torque, const double *load,
        const double *cage_speed, const double *ball_load, const double *place, const double *spin,
        SettlingOfRun *out))
{
  Settling settling(half);
  for (long k = std::max(0, samples - 2 * half); k < samples; ++k) {
    SettlingSample s;
    s.torque = torque[k];
    std::copy_n(load + 2 * k, 2, s.load);
    s.cage_speed = cage_speed[k];
    for (long b = k * balls; b < (k + 1) * balls; ++b)
      s.ball(ball_load[b], Vec3::from(place + 3 * b), Vec3::from(spin + 3 * b), {0.0, 0.0, 1.0});
    settling.add(s);
  }
  const bearing::SettlingChanges c = settling.changes();
  *out = {c.torque, c.load, c.cage_speed, c.spin_axis};
}
