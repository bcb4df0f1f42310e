// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_run.h"

#include "../core/figures/fix_columns.h"
#include "../core/numbers/number_list.h"
#include "../ranks/gather.h"
#include "compute_bearing_total.h"
#include "fix_bearing_cage_ring.h"
#include "fixes.h"
#include "integrator_work.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::RacewayContact;
using bearing::Settling;
using bearing::SettlingSample;
using raceway::Vec3;

FixBearingRun::FixBearingRun(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  for (int k = 3; k < narg; ++k) words_ += (k > 3 ? " " : "") + std::string(arg[k]);
  restart_global = 1;
  nevery = 1;
}

int FixBearingRun::setmask() { return END_OF_STEP | POST_RUN; }

void FixBearingRun::init()
{
  pair_ = PairBearingHertz::find(lmp, "run_bearing");
  const int k = modify->find_compute(id);
  total_ = k < 0 ? nullptr : dynamic_cast<ComputeBearingTotal *>(modify->compute[k]);
  has_pockets_ = pockets() > 0.0;
}

double FixBearingRun::pockets() const
{
  int most = 0;
  for (const FixBearingCageRing *f : bearing::fixes_of<FixBearingCageRing>(lmp))
    most = std::max(most, f->settings().of.pockets);
  return most;
}

void FixBearingRun::end_of_step()
{
  if (now_.steps == 0.0 || now_.measures != 0.0) return;
  const double done = static_cast<double>(update->ntimestep) - now_.first_step;
  if (done == 0.0 && orbit_.runs()) orbit_.begin(lmp);
  if (!(done > 0.0) || std::fmod(done, now_.every) != 0.0) return;
  now_.sum.add(sample());
  now_.samples += 1.0;
  if (done >= (now_.passes + 1.0) * now_.steps) end_pass();
}

// Sums over the bearings in the order of tags, so that the results are bitwise identical on any
// number of ranks. Unlike the largest load, the sum of the loads hardly depends on the positions of
// the balls.
SettlingSample FixBearingRun::sample()
{
  struct Ball {
    bearing::tag_t tag;
    double load[2];    // N, on the inner and the outer raceway
    Vec3 place, spin;
  };
  std::vector<Ball> balls;
  for (const RacewayContact &c : pair_->table().raceway) {
    if (balls.empty() || balls.back().tag != c.ball)
      balls.push_back({c.ball,
                       {},
                       Vec3::from(atom->x[c.i_ball]) - Vec3::from(atom->x[c.i_ring]),
                       Vec3::from(atom->omega[c.i_ball])});
    if (c.live) balls.back().load[c.side() == raceway::Side::inner ? 0 : 1] += c.state.load;
  }
  balls = bearing::gather_all(balls, world);
  std::sort(balls.begin(), balls.end(), [](const Ball &a, const Ball &b) { return a.tag < b.tag; });
  SettlingSample s;
  for (const Ball &b : balls) {
    s.ball(b.load[0] + b.load[1], b.place, b.spin, pair_->axis());
    for (int k = 0; k < 2; ++k) s.load[k] += b.load[k];
  }
  if (total_->invoked_vector != update->ntimestep) total_->compute_vector();
  const bearing::BearingFigures &of = total_->figures();
  for (const double power : of.loss) s.torque += power;
  s.torque += of.cage_loss;
  s.cage_speed = of.cage_speed();
  if (!has_pockets_) return s;
  s.pocket_force = of.cage_force;
  s.cage_orbit = cage_orbit();
  return s;
}

// Returns the mean of all one-piece cages.
double FixBearingRun::cage_orbit()
{
  using namespace bearing::of_fix_ring;
  double sum = 0.0, cages = 0.0;
  for (FixBearingCageRing *f : bearing::fixes_of<FixBearingCageRing>(lmp))
    for (int row = 0; row < f->size_array_rows; ++row) {
      const Vec3 at = {f->compute_array(row, X), f->compute_array(row, Y),
                       f->compute_array(row, Z)};
      const Vec3 off = at - pair_->axis() * dot(at, pair_->axis());
      const double half_play = f->settings().of.along;
      if (half_play > 0.0) sum += std::sqrt(dot(off, off)) / half_play;
      cages += 1.0;
    }
  return sum / cages;
}

void FixBearingRun::end_pass()
{
  passes_.push_back(now_.sum.times(1.0 / now_.samples));
  now_.sum = SettlingSample();
  now_.samples = 0.0;
  now_.passes += 1.0;
  if (now_.counted != 0.0) return;
  estimate_rest();
  if (orbit_.runs()) search_orbit();
}

// Evaluates a ball pass of the orbit search. If there is no orbit, the counter of ball passes
// restarts from 0.
void FixBearingRun::search_orbit()
{
  Settling settling;
  for (size_t k = passes_.size() > 1 ? passes_.size() - 2 : 0; k < passes_.size(); ++k)
    settling.add(passes_[k]);
  now_.changes = settling.changes();
  orbit_.end_pass(lmp, now_.changes, now_.settled);
  now_.step_length *= orbit_.now().stretch;
  if (orbit_.runs() || orbit_.found()) return;
  passes_.clear();
  now_.passes = 0.0;
  now_.changes = now_.rest = bearing::SettlingChanges();
  now_.first_step = now_.begin_steps = static_cast<double>(update->ntimestep);
}

// Called after the fix that may stop the run and write a restart file. In that case,
// write_restart() accounts for the current run.
void FixBearingRun::post_run()
{
  if (now_.measures == 0.0) now_.evaluations += bearing::integrator_work(lmp).evaluations;
}

void FixBearingRun::write_restart(FILE *fp)
{
  State kept = now_;
  if (now_.measures == 0.0 && update->whichflag != 0)
    kept.evaluations += bearing::integrator_work(lmp).evaluations;
  bearing::NumberWriter list, orbit;
  orbit_.keep(orbit);
  list(kept, passes_, orbit.numbers().size(), orbit.numbers());
  if (comm->me == 0) list.write(fp, words_ + '\0');
}

void FixBearingRun::restart(char *buf)
{
  bearing::NumberReader list(buf);
  list(now_);
  passes_.resize(static_cast<size_t>(now_.passes));
  size_t numbers;
  list(passes_, numbers);
  orbit_.keep(list);
  const std::string then = list.rest();
  if (then != words_)
    BRG_ALL("run_bearing: the restart file belongs to another run: '" + then + "', this one is '" +
            words_ + "'. Remove it, or resume with its settings");
  resumed_ = true;
}
