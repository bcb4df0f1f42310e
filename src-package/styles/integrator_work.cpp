// SPDX-License-Identifier: GPL-2.0-or-later
#include "integrator_work.h"

#include "../core/figures/fix_columns.h"
#include "fix_bearing_implicit.h"
#include "fixes.h"

#include <cmath>

using namespace LAMMPS_NS;

bearing::IntegratorWork bearing::integrator_work(LAMMPS *lmp)
{
  using namespace of_fix_implicit;
  IntegratorWork w;
  const std::vector<FixBearingImplicit *> implicit = fixes_of<FixBearingImplicit>(lmp);
  const Update &u = *lmp->update;
  if (implicit.empty()) w.steps = w.evaluations = static_cast<double>(u.ntimestep - u.firststep);
  double systems = 0.0;
  for (FixBearingImplicit *f : implicit) {
    const double steps = f->compute_vector(STEPS);
    w.steps += steps;
    w.evaluations += std::round(steps * f->compute_vector(CORRECTIONS));    // a whole number
    systems += f->systems();
  }
  if (systems > 0.0) {
    w.steps /= systems;
    w.evaluations /= systems;
  }
  return w;
}
