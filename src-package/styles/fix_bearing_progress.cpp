// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_progress.h"

#include "../core/figures/fix_columns.h"
#include "compute_bearing_total.h"
#include "fix_bearing_cage_ring.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "print_line.h"
#include "simulated_time.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::DrivenValue;

// fix ID group bearing/progress N COMPUTE [title WORD] [share V]
FixBearingProgress::FixBearingProgress(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  nevery = args.integer("steps between rows", 1, 1000000000);
  total_id_ = args.word("ID of a compute bearing/total");
  while (args.more())
    if (args.take("share")) share_ = DrivenValue::read(args, "share");
    else if (!args.word("title", title_, "title")) args.unknown();
}

int FixBearingProgress::setmask() { return END_OF_STEP | POST_RUN; }

void FixBearingProgress::init()
{
  share_.check(lmp, bearing::name_of(*this));
  const int k = modify->find_compute(total_id_.c_str());
  total_ = k < 0 ? nullptr : dynamic_cast<ComputeBearingTotal *>(modify->compute[k]);
  if (!total_)
    BRG_ALL(bearing::name_of(*this) + ": there is no compute bearing/total '" + total_id_ + "'");
}

void FixBearingProgress::setup(int)
{
  if (began_ == 0.0 || !share_.is_variable()) began_ = MPI_Wtime();
}

void FixBearingProgress::end_of_step() { show(); }

// Prints the last row, except if `share` is a variable, because this run is then one of many.
void FixBearingProgress::post_run()
{
  if (!share_.is_variable()) show();
}

double FixBearingProgress::share() const
{
  if (share_.is_variable()) return std::min(1.0, std::max(0.0, share_.now(lmp)));
  const bigint all = update->laststep - update->firststep;
  return all > 0 ? static_cast<double>(update->ntimestep - update->firststep) / all : 1.0;
}

void FixBearingProgress::show()
{
  if (update->ntimestep == shown_) return;
  shown_ = update->ntimestep;
  if (!headed_) {    // not printed during the set-up, when the host prints its own lines
    say(title_);
    say("  done %    left s      step      time s    ring um  loaded     load N    p GPa"
        "  cage rad/s");
    headed_ = true;
  }
  if (total_->invoked_vector != update->ntimestep) total_->compute_vector();
  const bearing::BearingFigures &of = total_->figures();
  double moved = 0.0;    // m, largest displacement of a raceway ring
  for (FixBearingRing *f : bearing::fixes_of<FixBearingRing>(lmp)) {
    if (dynamic_cast<FixBearingCageRing *>(f)) continue;
    double x[3];
    for (int k = 0; k < 3; ++k) x[k] = f->compute_vector(bearing::of_fix_ring::X + k);
    moved = std::max(moved, std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
  }
  const double done = share(), spent = MPI_Wtime() - began_;
  const double time = bearing::SimulatedTime::now(*update);
  char left[16] = "-";
  if (done > 0.0) snprintf(left, sizeof left, "%.1f", spent * (1.0 - done) / done);
  char line[160];
  snprintf(line, sizeof line, "%8.1f  %8s  %8.0f  %10.6f  %9.3f  %6.0f  %9.1f  %7.3f  %10.3f",
           100.0 * done, left, static_cast<double>(update->ntimestep), time, 1e6 * moved,
           of.loaded_balls, std::max(of.load[0], of.load[1]),
           1e-9 * std::max(of.pressure[0], of.pressure[1]), of.cage_speed());
  say(line);
}

void FixBearingProgress::say(const std::string &line) const
{
  if (!line.empty()) bearing::print_line(lmp, line);
}
