// SPDX-License-Identifier: GPL-2.0-or-later
// Output of fix bearing/capacitance: sums over the contacts, the global vector and the tables.
#include "../core/figures/fix_columns.h"
#include "../ranks/gather.h"
#include "fix_bearing_capacitance.h"

#include <algorithm>
#include <tuple>

using namespace LAMMPS_NS;
using namespace raceway;

namespace {
double figure(const FilmFigures &f, double hertz_area, int k)
{
  using namespace bearing::of_fix_capacitance;
  switch (k) {
    case LEAK: return f.leak;
    case IMPEDANCE: return f.impedance;
    case PHASE: return f.phase;
    case THRESHOLD: return f.threshold;
    case THRESHOLD_LOCAL: return f.local;
    case THRESHOLD_ENERGY: return f.energy;
    case HERTZ_AREA: return hertz_area;
  }
  return 0.0;
}
}    // namespace

// Computes the sums for each instant in the order of ball tags, so that they are bitwise identical
// on any number of ranks.
void FixBearingCapacitance::sum_up()
{
  if (summed_) return;
  summed_ = true;
  std::vector<Row> space;
  const std::vector<Row> *all = &bearing::gather_all(mine_, space, world);
  const auto before = [](const Row &a, const Row &b) {
    return std::make_tuple(a.instant, a.ball, a.side, a.groove) <
           std::make_tuple(b.instant, b.ball, b.side, b.groove);
  };
  if (!std::is_sorted(all->begin(), all->end(), before)) {
    if (all == &mine_) space = mine_;
    std::sort(space.begin(), space.end(), before);
    all = &space;
  }
  const int first_instant = between_ ? 1 : within_;
  const Row *row = all->data(), *last = row + all->size();
  for (int k = first_instant; k <= within_; ++k) {
    const Row *end = row;
    while (end != last && end->instant == k) ++end;
    total_ = add_up(row, end);
    plates_.add(total_.plates.all, k == first_instant);
    whole_.add(total_.whole.all, k == first_instant);
    if (between_ || written_ != update->ntimestep) write(row, end, k);
    row = end;
  }
  plates_.mean /= within_ - first_instant + 1;
  whole_.mean /= within_ - first_instant + 1;
}

// Until all instants have been added, `mean` contains their sum.
void FixBearingCapacitance::Spread::add(double value, bool first)
{
  if (first) *this = {0.0, value, value};
  mean += value;
  least = std::min(least, value);
  most = std::max(most, value);
}

// The contacts of a ball are adjacent rows. Capacitances between a ball and the same ring are
// added, and a ball in contact with only one ring contributes nothing.
FixBearingCapacitance::Total FixBearingCapacitance::add_up(const Row *row, const Row *end)
{
  Total t = {};
  balls_.clear();
  for (const Row *one = row; one != end; ++one) t.hertz_area += one->area;
  while (row != end) {
    const Row *const first = row;
    double plates[2] = {}, whole[2] = {};
    bool there[2] = {}, live[2] = {};
    for (; row != end && row->ball == first->ball; ++row) {
      const int s = static_cast<int>(row->side);
      plates[s] += row->of.capacitance;
      whole[s] += row->of.total();
      there[s] = true;
      live[s] = live[s] || row->live;
    }
    if (!there[0] || !there[1]) continue;
    const auto add = [](const double *of, Sum &to) {
      const double both = series_capacitance(of[0], of[1]);
      to.all += both;
      to.largest = std::max(to.largest, both);
    };
    add(plates, t.plates);
    if (model_.surrounded()) add(whole, t.whole);
    t.active += live[0] && live[1];
    if (!ask_.any()) continue;
    balls_.push_back({});
    for (const Row *one = first; one != row; ++one)
      balls_.back().film[static_cast<int>(one->side)].add(
          sampled_film(model_, one->of, one->area, one->roughness));
  }
  if (ask_.any()) t.figures = film_figures(ask_, balls_, background_);
  t.plates.all += background_;
  if (model_.surrounded()) t.whole.all += background_;
  return t;
}

void FixBearingCapacitance::write(const Row *row, const Row *end, int instant)
{
  written_ = update->ntimestep;
  const double back = double(within_ - instant) / within_;    // steps before the end of this step
  const double time = update->atime + (update->ntimestep - update->atimestep - back) * update->dt;
  const double step = update->ntimestep - back;
  const bool all = model_.surrounded();
  if (FILE *f = totals_.file()) {
    fprintf(f, "%.15g %.12g %.12g %.12g %.0f", step, time, total_.plates.all, total_.plates.largest,
            total_.active);
    if (all) fprintf(f, " %.12g %.12g", total_.whole.all, total_.whole.largest);
    if (ask_.any())
      for (int k = bearing::of_fix_capacitance::first_of_films; k < bearing::of_fix_capacitance::N;
           ++k)
        fprintf(f, " %.12g", figure(total_.figures, total_.hertz_area, k));
    fputc('\n', f);
  }
  if (FILE *f = contacts_.file())
    for (; row != end; ++row) {
      const FilmCapacitorT<double> &c = row->of;
      fprintf(f, "%.15g %.12g %d %d %.12g %.12g %.12g", step, time, static_cast<int>(row->ball),
              static_cast<int>(row->side), row->load, c.h_c, c.capacitance);
      if (all) fprintf(f, " %.12g %.12g %.12g", c.separation, c.outside, c.total());
      if (grooves_) fprintf(f, " %d", row->groove);
      fputc('\n', f);
    }
  if (update->ntimestep == update->laststep)
    for (FILE *f : {totals_.file(), contacts_.file()})
      if (f) fflush(f);
}

double FixBearingCapacitance::compute_scalar()
{
  using namespace bearing::of_fix_capacitance;
  return compute_vector(model_.surrounded() ? ALL_TOTAL : TOTAL);
}

double FixBearingCapacitance::compute_vector(int k)
{
  sum_up();
  using namespace bearing::of_fix_capacitance;
  switch (k) {
    case TOTAL: return total_.plates.all;
    case LARGEST: return total_.plates.largest;
    case ACTIVE: return total_.active;
    case MEAN: return plates_.mean;
    case LEAST: return plates_.least;
    case MOST: return plates_.most;
    case ALL_TOTAL: return total_.whole.all;
    case ALL_LARGEST: return total_.whole.largest;
    case ALL_MEAN: return whole_.mean;
    case ALL_LEAST: return whole_.least;
    case ALL_MOST: return whole_.most;
  }
  return figure(total_.figures, total_.hertz_area, k);
}
