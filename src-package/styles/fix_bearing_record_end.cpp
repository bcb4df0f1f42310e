// SPDX-License-Identifier: GPL-2.0-or-later
// Measures the time and the number of steps spent by a run. The clocks are stopped at the end of
// the run, and both values are stored in restart files.
#include "../core/numbers/number_list.h"
#include "fix_bearing_record.h"
#include "integrator_work.h"
#include "record_settings.h"

#include <algorithm>
#include <ctime>

using namespace LAMMPS_NS;

// Returns the processor time used by this process, in s.
static double processor_time() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void FixBearingRecord::start_clocks()
{
  clocks_.wall = MPI_Wtime();
  clocks_.processor = processor_time();
  running_ = true;
}

// Measures the time from the first sample until the operating system has received the last sample.
void FixBearingRecord::stop_clocks()
{
  flush();
  if (file_) refuse_write(file_->file().hand_over());
  spent_ = spent_now();
  running_ = false;
}

void FixBearingRecord::post_run()
{
  if (waits() || over_) return;
  if (running_) stop_clocks();
  left_ = static_cast<double>(update->ntimestep);
  if (comm->me != 0) return;
  const bool done = update->ntimestep == update->laststep;    // false if a signal stopped the run
  if (file_) refuse_write(file_->file().put_fixed(file_->finished(), done));
  const double time = time_of(last_step_);
  if (done)
    refuse(bearing::write_run_yaml(folder_, about_,
                                   {{"step_s", time / std::max(spent_.steps, 1.0)},
                                    {"evaluations", spent_.evaluations},
                                    {"processor_s", spent_.processor},
                                    {"simulated_s", time},
                                    {"wall_s", spent_.wall}}));
}

// Returns the time and steps spent in the current run so far. Must be called on all ranks.
FixBearingRecord::Spent FixBearingRecord::made() const
{
  Spent s;
  s.wall = MPI_Wtime() - clocks_.wall;
  s.processor = processor_time() - clocks_.processor;
  const bearing::IntegratorWork work = bearing::integrator_work(lmp);
  s.steps = work.steps;
  s.evaluations = work.evaluations;
  return s;
}

// Returns the time and steps spent so far, including previous runs. Must be called on all ranks.
FixBearingRecord::Spent FixBearingRecord::spent_now() const
{
  if (!running_) return spent_;
  const Spent now = made();
  Spent sum;
  sum.wall = spent_.wall + now.wall;
  sum.processor = spent_.processor + now.processor;
  sum.steps = spent_.steps + now.steps;
  sum.evaluations = spent_.evaluations + now.evaluations;
  return sum;
}

// Before the state is stored, all samples that are counted in the restart file are written to the
// record. Must be called on all ranks.
void FixBearingRecord::write_restart(FILE *fp)
{
  flush();
  if (file_) refuse(file_->file().settle());
  bearing::NumberWriter list;
  list(samples_, first_step_, start_, last_step_, spent_now(), update->ntimestep, oil_.size(),
       commands_.size(), oil_);
  if (comm->me == 0) list.write(fp, commands_);
}

void FixBearingRecord::restart(char *buf)
{
  bearing::NumberReader list(buf);
  size_t oils = 0, letters = 0;
  list(samples_, first_step_, start_, last_step_, spent_, left_, oils, letters);
  oil_.resize(oils);
  list(oil_);
  commands_.assign(list.rest(), letters);
  resumed_ = samples_ > 0.0;
  allowed_ = true;    // the run that wrote the restart file was allowed to overwrite the folder
}
