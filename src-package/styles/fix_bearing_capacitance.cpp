// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_capacitance.h"

#include "../contacts/fix_columns.h"
#include "../deck/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_implicit.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>
#include <tuple>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::RacewayContact;
using bearing::tag_t;

// fix ID group bearing/capacitance N permittivity EPS [background C] [film_floor H] [within M]
// [file F] [contacts F]
FixBearingCapacitance::FixBearingCapacitance(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/capacitance"))
{
  Arguments args(lmp, std::string("fix ") + id + " bearing/capacitance", narg, arg, 3);
  std::string totals, contacts;
  nevery = args.integer("steps between samples", 1, 1000000000);
  while (args.more()) {
    if (args.take("permittivity")) {
      permittivity_ = args.within("relative permittivity at ambient pressure", 1.0, 10.0);
    } else if (args.take("background")) {
      background_ = args.non_negative("background capacitance (F)");
    } else if (args.take("film_floor")) {
      shortest_film_ = args.positive("thinnest film of a capacitor (m)");
    } else if (args.take("within")) {
      within_ = args.integer("instants a step", 1, 100000);
    } else if (args.take("file")) {
      totals = args.word("name of the file");
    } else if (args.take("contacts")) {
      contacts = args.word("name of the file for contacts");
    } else {
      args.unknown("permittivity, background, film_floor, within, file, contacts");
    }
  }
  if (within_ > 1 && nevery != 1)
    args.fail("'within' takes samples evenly within every step: N must be 1, not " +
              std::to_string(nevery));
  if (permittivity_ == 0.0) args.fail("'permittivity EPS' is missing");
  if (!pair_->lubricated())
    args.fail("a dry contact has no capacitance: use pair_style bearing/ehd");
  if (!totals.empty())
    totals_.open(args, totals, "step time capacitance largest_ball active_balls", world);
  if (!contacts.empty())
    contacts_.open(args, contacts, "step time ball raceway load h_c capacitance", world);
  scalar_flag = vector_flag = 1;
  size_vector = bearing::of_fix_capacitance::N;
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

void FixBearingCapacitance::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/capacitance");
}

void FixBearingCapacitance::setup(int)
{
  if (within_ > 1) find_integrators();
  sample(false);
}

void FixBearingCapacitance::end_of_step() { sample(true); }

// Those whose steps the instants lie within, and which of their balls count.
void FixBearingCapacitance::find_integrators()
{
  integrators_ = bearing::fixes_of<FixBearingImplicit>(lmp);
  if (integrators_.empty())
    BRG_ALL(std::string("fix ") + id + " bearing/capacitance: 'within " + std::to_string(within_) +
            "' needs fix bearing/implicit, which knows what happens within a step; with other "
            "integrators sample every step");
  for (FixBearingImplicit *f : integrators_)
    f->want_instants(instants(within_), std::string("fix ") + id + " bearing/capacitance");
  members_ = find_members();
}

std::vector<tag_t> FixBearingCapacitance::find_members() const
{
  std::vector<tag_t> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) mine.push_back(atom->tag[i]);
  std::vector<tag_t> all = bearing::gather_all(mine, world);
  std::sort(all.begin(), all.end());
  return all;
}

FilmCapacitorT<double> FixBearingCapacitance::capacitor(const RacewayContact &c) const
{
  return film_capacitor(*c.raceway, c.state, permittivity_, shortest_film_);
}

// What the homes of the bearings know.
void FixBearingCapacitance::add_instants()
{
  for (FixBearingImplicit *f : integrators_)
    for (int k = 1; k < within_; ++k)
      f->read_instant(k,
                      {[this, k](const bearing::InstantContact &c) {
                         if (c.live && std::binary_search(members_.begin(), members_.end(), c.ball))
                           mine_.push_back({k, c.ball, c.raceway.groove.side, c.state.load,
                                            c.capacitor.h_c, c.capacitor.capacitance});
                       },
                       {},
                       {}});
}

// What the owners of the balls know. Sums over all ranks wait until somebody asks: a table by ring
// does not.
void FixBearingCapacitance::sample(bool between)
{
  mine_.clear();
  if (between) add_instants();
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
  for (const RacewayContact &c : pair_->table().raceway)
    if (c.live && (atom->mask[c.i_ball] & groupbit)) {
      const FilmCapacitorT<double> q = capacitor(c);
      per_ball_[c.i_ball][c.side() == Side::inner ? 0 : 1] = q.capacitance;
      mine_.push_back({within_, c.ball, c.side(), c.state.load, q.h_c, q.capacitance});
    }
  for (int i = 0; i < atom->nlocal; ++i)
    per_ball_[i][2] = series_capacitance(per_ball_[i][0], per_ball_[i][1]);
  between_ = between;
  summed_ = false;
  if (totals_.wanted() || contacts_.wanted()) sum_up();
}

// Instant by instant, and by ball tag within one: the same bits on any number of ranks.
void FixBearingCapacitance::sum_up()
{
  if (summed_) return;
  summed_ = true;
  std::vector<Row> space;
  const std::vector<Row> *all = &bearing::gather_all(mine_, space, world);
  const auto before = [](const Row &a, const Row &b) {
    return std::make_tuple(a.instant, a.ball, a.side) < std::make_tuple(b.instant, b.ball, b.side);
  };
  if (!std::is_sorted(all->begin(), all->end(), before)) {
    if (all == &mine_) space = mine_;
    std::sort(space.begin(), space.end(), before);
    all = &space;
  }
  const int first_instant = between_ ? 1 : within_;
  double sum = 0.0;
  const Row *row = all->data(), *last = row + all->size();
  for (int k = first_instant; k <= within_; ++k) {
    const Row *end = row;
    while (end != last && end->instant == k) ++end;
    total_ = add_up(row, end);
    sum += total_.sum;
    least_ = k == first_instant ? total_.sum : std::min(least_, total_.sum);
    most_ = k == first_instant ? total_.sum : std::max(most_, total_.sum);
    if (between_ || written_ != update->ntimestep) write(row, end, k);
    row = end;
  }
  mean_ = sum / (within_ - first_instant + 1);
}

// A ball's two contacts stand side by side; one alone adds nothing.
FixBearingCapacitance::Total FixBearingCapacitance::add_up(const Row *row, const Row *end) const
{
  Total t = {};
  for (; row + 1 < end; ++row) {
    if (row[0].ball != row[1].ball) continue;
    const double both = series_capacitance(row[0].capacitance, row[1].capacitance);
    t.sum += both;
    t.largest = std::max(t.largest, both);
    t.active += 1.0;
    ++row;
  }
  t.sum += background_;
  return t;
}

void FixBearingCapacitance::write(const Row *row, const Row *end, int instant)
{
  written_ = update->ntimestep;
  const double back = double(within_ - instant) / within_;    // steps before the end of this one
  const double time = update->atime + (update->ntimestep - update->atimestep - back) * update->dt;
  const double step = update->ntimestep - back;
  if (FILE *f = totals_.file())
    fprintf(f, "%.15g %.12g %.12g %.12g %.0f\n", step, time, total_.sum, total_.largest,
            total_.active);
  if (FILE *f = contacts_.file())
    for (; row != end; ++row)
      fprintf(f, "%.15g %.12g %d %d %.12g %.12g %.12g\n", step, time, static_cast<int>(row->ball),
              static_cast<int>(row->side), row->load, row->h_c, row->capacitance);
  if (update->ntimestep == update->laststep)
    for (FILE *f : {totals_.file(), contacts_.file()})
      if (f) fflush(f);
}

double FixBearingCapacitance::compute_scalar()
{
  return compute_vector(bearing::of_fix_capacitance::TOTAL);
}

double FixBearingCapacitance::compute_vector(int k)
{
  sum_up();
  using namespace bearing::of_fix_capacitance;
  switch (k) {
    case TOTAL: return total_.sum;
    case LARGEST: return total_.largest;
    case ACTIVE: return total_.active;
    case MEAN: return mean_;
    case LEAST: return least_;
    case MOST: return most_;
  }
  return 0.0;
}

void FixBearingCapacitance::grow_arrays(int n)
{
  memory->grow(per_ball_, n, 3, "bearing/capacitance:per_ball");
  array_atom = per_ball_;
}

void FixBearingCapacitance::copy_arrays(int i, int j, int)
{
  for (int k = 0; k < 3; ++k) per_ball_[j][k] = per_ball_[i][k];
}

void FixBearingCapacitance::set_arrays(int i)
{
  per_ball_[i][0] = per_ball_[i][1] = per_ball_[i][2] = 0.0;
}

double FixBearingCapacitance::memory_usage() { return 3.0 * atom->nmax * sizeof(double); }
