// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_timestep.h"

#include "../contacts/step_check.h"
#include "../core/figures/fix_columns.h"
#include "../core/numbers/number_list.h"
#include "../core/settings/arguments.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "simulated_time.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::text;

static constexpr double shortest_step = 1e-12;    // s

// fix ID group bearing/timestep N [safety F] [adapt yes|no] [max DT] [exceed ignore|warn|stop]
FixBearingTimestep::FixBearingTimestep(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/timestep"))
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  nevery = args.integer("steps between checks", 1, 1000000000);
  while (args.more())
    if (args.take("exceed")) exceed_ = args.choice("exceed", {"ignore", "warn", "stop"});
    else if (!args.within("safety", safety_, "safety", 1e-3, 1.0) && !args.yes("adapt", adapt_) &&
             !args.within("max", largest_, "largest step (s)", shortest_step, HUGE_VAL))
      args.unknown();
  time_depend = adapt_ ? 1 : 0;
  restart_global = 1;
  bearing::provide_values(*this, bearing::of_fix_timestep::N);
}

int FixBearingTimestep::setmask() { return END_OF_STEP; }

void FixBearingTimestep::init() { pair_ = PairBearingHertz::find(lmp, "fix bearing/timestep"); }

void FixBearingTimestep::setup(int)
{
  run_start_ = MPI_Wtime();
  if (!goes_on_) check();
  goes_on_ = false;
}

void FixBearingTimestep::end_of_step() { check(); }

void FixBearingTimestep::check()
{
  const bearing::StepLimit limit = bearing::step_limit(lmp, pair_->table());
  limit_ = limit.step;
  smallest_limit_ = std::min(smallest_limit_, limit_);
  if (adapt_) {
    // the step is decreased immediately, but increased by at most a fifth per check, because the
    // limit does not include contacts that are about to close
    const double wanted = std::min({safety_ * limit_, 1.2 * update->dt, largest_});
    if (!(wanted >= shortest_step))
      BRG_ALL(bearing::name_of(*this) + ": " + limit.why() + " allows only " + text(limit_) +
              " s, less than " + text(shortest_step) + " s; the time would no longer advance");
    if (wanted != update->dt) set_step(wanted);
    return;
  }
  if (update->dt <= limit_ || exceed_ == ignore) return;
  const std::string message = bearing::name_of(*this) + ": step " + text(update->dt) +
                              " s exceeds what " + limit.why() + " allows, " + text(limit_) +
                              " s, at step " + std::to_string(update->ntimestep);
  if (exceed_ == stop) BRG_ALL(message);
  if (!warned_ && comm->me == 0) BRG_WARN(message);
  warned_ = true;
}

void FixBearingTimestep::set_step(double dt)
{
  update->update_time();    // the thermo keyword 'time' must remain continuous with steps of
                            // varying length
  update->dt = dt;
  if (force->pair) force->pair->reset_dt();
  for (int i = 0; i < modify->nfix; ++i) modify->fix[i]->reset_dt();
}

double FixBearingTimestep::compute_scalar() { return limit_; }

double FixBearingTimestep::compute_vector(int k)
{
  using namespace bearing::of_fix_timestep;
  switch (k) {
    case LIMIT: return limit_;
    case SMALLEST: return smallest_limit_;
    case TIME: return bearing::SimulatedTime::now(*update);
    case WALL: return MPI_Wtime() - run_start_;
  }
  return 0.0;
}

void FixBearingTimestep::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  list(update->dt, limit_, smallest_limit_);
  if (comm->me == 0) list.write(fp);
}

// An adaptive run continues with its last step without checking it again.
void FixBearingTimestep::restart(char *buf)
{
  if (!adapt_) return;
  bearing::NumberReader{buf}(update->dt, limit_, smallest_limit_);
  goes_on_ = true;
}
