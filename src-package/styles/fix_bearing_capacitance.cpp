// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_capacitance.h"

#include "../physics/capacitance.h"
#include "arguments.h"
#include "gather.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::RacewayContact;

// fix ID group bearing/capacitance N permittivity EPS [background C] [film_floor H]
FixBearingCapacitance::FixBearingCapacitance(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/capacitance"))
{
  Arguments args(lmp, std::string("fix ") + id + " bearing/capacitance", narg, arg, 3);
  nevery = args.integer("steps between samples", 1, 1000000000);
  while (args.more()) {
    if (args.take("permittivity")) {
      permittivity_ = args.within("relative permittivity at ambient pressure", 1.0, 10.0);
    } else if (args.take("background")) {
      background_ = args.non_negative("background capacitance (F)");
    } else if (args.take("film_floor")) {
      shortest_film_ = args.positive("thinnest film of a capacitor (m)");
    } else {
      args.unknown("permittivity, background, film_floor");
    }
  }
  if (permittivity_ == 0.0) args.fail("'permittivity EPS' is missing");
  if (!pair_->lubricated()) args.fail("a dry contact has no capacitance: use pair_style bearing/ehd");
  scalar_flag = vector_flag = 1;
  size_vector = 3;
  extscalar = extvector = 0;
  global_freq = nevery;
  peratom_flag = 1;
  size_peratom_cols = 3;
  peratom_freq = nevery;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
}

FixBearingCapacitance::~FixBearingCapacitance()
{
  atom->delete_callback(id, 0);
  memory->destroy(per_ball_);
}

int FixBearingCapacitance::setmask() { return END_OF_STEP; }

void FixBearingCapacitance::init() { pair_ = PairBearingHertz::find(lmp, "fix bearing/capacitance"); }

void FixBearingCapacitance::setup(int) { sample(); }
void FixBearingCapacitance::end_of_step() { sample(); }

double FixBearingCapacitance::central_film(const RacewayContact &c) const
{
  const RacewayConstants k = c.raceway->law.at(c.state.cos_angle);
  const double h = film_thickness(k.film.central, std::log(c.state.entrainment), std::log(c.state.load));
  return h > shortest_film_ ? h : shortest_film_;
}

double FixBearingCapacitance::contact(const RacewayContact &c) const
{
  const RacewayConstants k = c.raceway->law.at(c.state.cos_angle);
  const double eps = permittivity_at(permittivity_, k.p * c.state.root);
  return contact_capacitance(eps, k.a * c.state.root, k.b * c.state.root, central_film(c));
}

void FixBearingCapacitance::sample()
{
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
  for (const RacewayContact &c : pair_->table().raceway)
    if (c.live && (atom->mask[c.i_ball] & groupbit)) per_ball_[c.i_ball][c.side() == Side::inner ? 0 : 1] = contact(c);
  struct Ball { bearing::tag_t tag; double series; };
  std::vector<Ball> mine;
  for (int i = 0; i < atom->nlocal; ++i) {
    per_ball_[i][2] = series_capacitance(per_ball_[i][0], per_ball_[i][1]);
    if (per_ball_[i][2] > 0.0) mine.push_back({atom->tag[i], per_ball_[i][2]});
  }
  std::vector<Ball> all = bearing::gather_all(mine, world);    // summed by tag: the same bits on any number of ranks
  std::sort(all.begin(), all.end(), [](const Ball &a, const Ball &b) { return a.tag < b.tag; });
  total_ = largest_ = 0.0;
  active_ = static_cast<double>(all.size());
  for (const Ball &b : all) {
    total_ += b.series;
    largest_ = std::max(largest_, b.series);
  }
  total_ += background_;
}

double FixBearingCapacitance::compute_scalar() { return total_; }

// 1: bearing total with background, 2: largest single ball, 3: number of active balls
double FixBearingCapacitance::compute_vector(int k) { return k == 0 ? total_ : k == 1 ? largest_ : active_; }

void FixBearingCapacitance::grow_arrays(int n)
{
  memory->grow(per_ball_, n, 3, "bearing/capacitance:per_ball");
  array_atom = per_ball_;
}

void FixBearingCapacitance::copy_arrays(int i, int j, int)
{
  for (int k = 0; k < 3; ++k) per_ball_[j][k] = per_ball_[i][k];
}

void FixBearingCapacitance::set_arrays(int i) { per_ball_[i][0] = per_ball_[i][1] = per_ball_[i][2] = 0.0; }

double FixBearingCapacitance::memory_usage() { return 3.0 * atom->nmax * sizeof(double); }
