// SPDX-License-Identifier: GPL-2.0-or-later
// The cost of a run in steps of the integrator and force evaluations, which do not depend on the
// load of the machine.
#ifndef BEARING_INTEGRATOR_WORK_H
#define BEARING_INTEGRATOR_WORK_H

#include "bearing_compat.h"

namespace bearing {

struct IntegratorWork {
  double steps = 0.0, evaluations = 0.0;    // per bearing
};

// Work from the start of the present run until its post_run(); collective. Velocity Verlet
// evaluates the forces once per step.
IntegratorWork integrator_work(LAMMPS_NS::LAMMPS *);

}    // namespace bearing

#endif
