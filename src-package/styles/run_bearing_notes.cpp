// SPDX-License-Identifier: GPL-2.0-or-later
// Describes the state in which a measurement begins: messages and notes in the record.
#include "fix_bearing_record.h"
#include "print_line.h"
#include "run_bearing.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::SettlingChanges;

// The whirl of a cage may grow for a hundred ball passes and more, with hardly any effect on the
// torque (docs/cage.rst). Settling therefore does not wait for it.
void RunBearing::say_cage_orbit()
{
  constexpr double much = 0.1;    // of half the play; most orbits that repeat change less
  const double change = now().rest.cage_orbit;
  if (fix_->orbit().found() || !std::isfinite(change) || change <= much) return;
  char line[160];
  snprintf(line, sizeof line,
           "The orbit of the cage has not settled: it changes by %.2g of half the pocket play; "
           "pocket forces may change",
           change);
  bearing::print_line(lmp, line);
}

void RunBearing::note_settling(FixBearingRecord &f)
{
  const bearing::OrbitSearch &orbit = fix_->orbit();
  const SettlingChanges &c = orbit.found() ? now().changes : now().rest;
  if (automatic()) {
    if (settings_.orbit) note_orbit(f);
    f.note({"settled_passes", now().passes});
    f.note({"rest_torque", c.torque});
    f.note({"rest_load", c.load});
    f.note({"rest_cage_speed", c.cage_speed});
    f.note({"rest_spin_axis_rad", c.spin_axis});
    if (fix_->pockets() > 0.0) f.note({"settled_pocket_fall", c.pocket_fall});
  }
  if (fix_->pockets() > 0.0 && std::isfinite(c.cage_orbit))
    f.note({"rest_cage_orbit", c.cage_orbit});
  if (orbit.found()) return;    // its ball passes do not follow each other without interruption
  const SettlingChanges w = fix_->wander(std::max(1.0, std::round(settings_.passes)));
  if (!std::isfinite(w.torque)) return;
  // an extended run measures more ball passes, whose means wander less
  f.note({"wander_torque", w.torque}, true);
  f.note({"wander_cage_speed", w.cage_speed}, true);
}
