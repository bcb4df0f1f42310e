// SPDX-License-Identifier: GPL-2.0-or-later
// Hooks of the pair style that are called by fix bearing/state. They register the rails and
// contacts of this rank in the sums over rings, and check the step and the validity ranges of the
// laws.
#include "pair_bearing_hertz.h"

#include "../contacts/step_check.h"
#include "../core/settings/arguments.h"

using namespace LAMMPS_NS;
using bearing::text;

static constexpr int steps_between_checks = 1000;    // of the step size

// Causes rails (pre_force) and contacts (compute) to renew their claims in the sums over the rings.
void PairBearingHertz::indices_changed()
{
  ring_sum_.reset();
  for (int i = 0; i < atom->nlocal; ++i)
    if (coefficients_.is_ring(atom->type[i])) ring_sum_.own(i, atom->tag[i]);
}

void PairBearingHertz::forces_known() { check_step(); }

void PairBearingHertz::after_step()
{
  validity_.look(table_, atom->mask, coefficients_.lubricated());
  if (update->ntimestep % steps_between_checks == 0) check_step();
}

void PairBearingHertz::run_done()
{
  validity_.look(table_, atom->mask, coefficients_.lubricated());
  validity_.report(lmp, capacitors_);
}

void PairBearingHertz::add_capacitor(int groupbit, const raceway::CapacitorModel &model)
{
  capacitors_ = true;
  gaps_ = gaps_ || model.surrounded();
  validity_.add_shoulders(groupbit, model);
}

// Checks the step of velocity Verlet. The substeps of fix bearing/implicit need no such check.
void PairBearingHertz::check_step()
{
  if (implicit_bits_) return;
  const bearing::StepLimit limit = bearing::step_limit(lmp, table_);
  const double ratio = update->dt / limit.step;
  if (ratio > 10.0)
    BRG_ALL("timestep " + text(update->dt) + " s: " + limit.why() + " allows at most " +
            text(limit.step) + " s");
  if (ratio > 1.0 && !warned_ && comm->me == 0)
    BRG_WARN("timestep " + text(update->dt) + " s is too large for velocity Verlet: " +
             limit.why() + " allows at most " + text(limit.step) + " s; see fix bearing/timestep");
  if (ratio > 1.0) warned_ = true;
}
