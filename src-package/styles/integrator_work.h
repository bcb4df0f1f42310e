// SPDX-License-Identifier: GPL-2.0-or-later
// Measures the cost of a run in integrator steps and force evaluations, because these do not depend
// on the load of the machine.
#pragma once

#include "bearing_compat.h"

namespace bearing {

struct IntegratorWork {
  double steps = 0.0, evaluations = 0.0;    // numbers per bearing
};

// Returns the work from the start of the current run until its post_run(). Must be called on all
// ranks. Velocity Verlet evaluates the forces once per step.
IntegratorWork integrator_work(LAMMPS_NS::LAMMPS *);

}    // namespace bearing
