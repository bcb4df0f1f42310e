// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the settling of a recorded run (settling.h, settling_rest.h).
#include "../figures/settling_rest.h"
#include "exports.h"

#include <algorithm>

using bearing::SettlingSample;
using raceway::Vec3;

RECORD(SettlingOfRun, double torque, load, cage_speed, spin_axis, cage_orbit, remaining_torque,
       remaining_load, remaining_cage_speed, remaining_spin_axis;)

// Computes the changes between the last two of `passes` ball passes of `samples` samples each, and
// estimates the changes that remain after the last one. The change of a cage's orbit is that
// between the last two quarters of the ball passes, if there are at least four. The input contains
// the friction torque, the largest load on each raceway, the cage speed and the orbit of a
// one-piece cage (as a fraction of half the play) for every sample, and the load, the position
// relative to the bearing's centre and the spin for every sample and ball, with z along the
// bearing's axis. From n steps between ball passes, a decay by less than 1/n per ball pass cannot
// be distinguished from a constant drift. If there are fewer than two ball passes, the changes are
// infinite.
EXPORT(void, settling,
       (int passes, int samples, int balls, const double *torque, const double *load,
        const double *cage_speed, const double *cage_orbit, const double *ball_load,
        const double *place, const double *spin, SettlingOfRun *out))
{
  std::vector<SettlingSample> means(static_cast<size_t>(passes));
  for (long k = 0; k < static_cast<long>(passes) * samples; ++k) {
    SettlingSample s;
    s.torque = torque[k];
    std::copy_n(load + 2 * k, 2, s.load);
    s.cage_speed = cage_speed[k];
    s.cage_orbit = cage_orbit[k];
    for (long b = k * balls; b < (k + 1) * balls; ++b)
      s.ball(ball_load[b], Vec3::from(place + 3 * b), Vec3::from(spin + 3 * b), {0.0, 0.0, 1.0});
    means[static_cast<size_t>(k / samples)].add(s, 1.0 / samples);
  }
  bearing::Settling last(1);
  for (const SettlingSample &pass : means) last.add(pass);
  const bearing::SettlingChanges c = last.changes(),
                                 rest = bearing::settling_rest(means,
                                                               1.0 - 1.0 / std::max(1, passes - 1));
  *out = {c.torque,    c.load,    c.cage_speed,    c.spin_axis,   rest.cage_orbit,
          rest.torque, rest.load, rest.cage_speed, rest.spin_axis};
}
