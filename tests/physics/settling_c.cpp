// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the estimates of the change that remains after ball passes to test_physics_settling.py.
#include "../../src-package/core/figures/settling_rest.h"
#include "../../src-package/core/interface/exports.h"

RECORD(SettlingRest, double torque, load, cage_speed, spin_axis, pocket_fall, cage_orbit;)

// Estimates, from the means over each ball pass, the remaining changes in torque, load on each
// raceway, cage speed, pocket force, pitch angle of the spin axis (rad) and orbit of the cage or,
// if `window` is not 0, how far means over so many ball passes wander.
EXPORT(void, settling_rest,
       (int passes, int window, const double *torque, const double *load, const double *cage_speed,
        const double *pocket_force, const double *pitch, const double *cage_orbit,
        SettlingRest *out))
{
  std::vector<bearing::SettlingSample> all(static_cast<size_t>(passes));
  for (size_t k = 0; k < all.size(); ++k) {
    bearing::SettlingSample &one = all[k];
    one.torque = torque[k];
    one.load[0] = load[2 * k];
    one.load[1] = load[2 * k + 1];
    one.cage_speed = cage_speed[k];
    one.pocket_force = pocket_force[k];
    one.cage_orbit = cage_orbit[k];
    one.weight = 100.0;
    one.axis[0] = 100.0 * std::sin(pitch[k]);
    one.axis[2] = 100.0 * std::cos(pitch[k]);
  }
  const bearing::SettlingChanges c =
      window == 0 ? bearing::settling_rest(all)
                  : bearing::settling_wander(all, static_cast<size_t>(window));
  *out = {c.torque, c.load, c.cage_speed, c.spin_axis, c.pocket_fall, c.cage_orbit};
}
