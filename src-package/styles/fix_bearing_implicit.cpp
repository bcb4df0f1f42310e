// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_implicit.h"

#include "arguments.h"
#include "fix_bearing_cage.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::ImplicitBearing;
using bearing::text;

static constexpr double smallest_step = 1e-12;    // s

// fix ID group bearing/implicit [tolerance T] [predictor M] [corrections N] [largest H] [creep C]
FixBearingImplicit::FixBearingImplicit(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/implicit"))
{
  Arguments args(lmp, std::string("fix ") + id + " bearing/implicit", narg, arg, 3);
  while (args.more()) {
    if (args.take("tolerance")) tolerance_ = args.within("tolerance (m)", 1e-12, 1e-4);
    else if (args.take("corrections")) most_ = args.integer("corrections in a step", 1, 100);
    else if (args.take("predictor")) miss_ = args.within("allowed miss of the predictor (m)", 1e-12, 1.0);
    else if (args.take("largest")) largest_ = args.positive("largest step (s)");
    else if (args.take("creep")) creep_ = args.within("creep of the smoothed friction", 1e-6, 1.0);
    else args.unknown("tolerance, corrections, predictor, largest, creep");
  }
  if (miss_ == 0.0) miss_ = 30.0 * tolerance_;
  if (miss_ < tolerance_)
    args.fail("predictor " + text(miss_) + " m must not be below the tolerance, " + text(tolerance_) + " m");
  if (comm->nprocs > 1)    // sums over balls of other ranks are still to be written
    args.fail("runs on one rank, not on " + std::to_string(comm->nprocs) + ": give each rank its own bearing with a "
              "partition, or use the explicit integrator (fix nve/sphere)");
  time_integrate = 1;
  restart_global = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 6;
  global_freq = 1;
  extscalar = extvector = 0;
}

int FixBearingImplicit::setmask() { return INITIAL_INTEGRATE; }

void FixBearingImplicit::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/implicit");
  check_fixes();
  rings_.clear();
  for (int k = 0; k < modify->nfix; ++k)
    if (FixBearingRing *r = dynamic_cast<FixBearingRing *>(modify->fix[k])) {
      bool mine = false, others = false;
      for (int i = 0; i < atom->nlocal; ++i)
        if (r->moves(i)) (atom->mask[i] & groupbit ? mine : others) = true;
      if (mine && others)
        BRG_ONE(std::string("fix ") + id + " bearing/implicit: its group has some rings of fix " + r->id +
                " but not all of them");
      if (mine) rings_.push_back(r);
    }
  if (pair_->smooth_friction(creep_) && comm->me == 0) {
    const std::string say = std::string("fix ") + id + " bearing/implicit: friction smoothed over a creep of " +
        text(creep_) + " of the entrainment speed\n";
    if (screen) fputs(say.c_str(), screen);
    if (logfile) fputs(say.c_str(), logfile);
  }
}

// Nobody else moves these atoms, and nobody pushes them unseen.
void FixBearingImplicit::check_fixes()
{
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix &f = *modify->fix[k];
    if (&f == this || strncmp(f.style, "bearing/", 8) == 0) {
      if (&f != this && strcmp(f.style, "bearing/implicit") == 0)
        for (int i = 0; i < atom->nlocal; ++i)
          if ((atom->mask[i] & groupbit) && (atom->mask[i] & f.groupbit))
            BRG_ONE(std::string("fix ") + id + " bearing/implicit and fix " + f.id + " both move atom " +
                    std::to_string(atom->tag[i]));
      continue;
    }
    const char *does = f.time_integrate ? "moves them too" : modify->fmask[k] & POST_FORCE ? "adds forces that "
                                                                   "an implicit step does not see" : nullptr;
    for (int i = 0; does && i < atom->nlocal; ++i)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & f.groupbit))
        BRG_ONE(std::string("fix ") + id + " bearing/implicit: its group has atoms of fix " + f.id + " (" + f.style +
                "), which " + does);
  }
}

void FixBearingImplicit::setup(int)
{
  build_ = -1;
  substeps_ = corrections_ = refused_ = time_ = worst_ = 0.0;
  smallest_ = HUGE_VAL;
}

// One part for everything that may touch: contacts of the table join what they have in common.
void FixBearingImplicit::build()
{
  if (build_ == pair_->table_build()) return;
  build_ = pair_->table_build();
  for (const Part &p : parts_) wish_ = std::min(wish_, p.step);
  parts_.clear();
  const bearing::ContactTable &table = pair_->table();
  const int n = atom->nlocal;
  std::vector<int> root(n);
  for (int i = 0; i < n; ++i) root[i] = i;
  auto find = [&root](int i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  auto join = [&](int i, int j) { root[find(i)] = find(j); };
  for (const bearing::RacewayContact &c : table.raceway) join(c.i_ball, c.i_ring);
  for (const bearing::SphereContact &s : table.sphere) join(s.i, s.j);
  std::vector<FixBearingRing *> mover(n, nullptr);
  for (int k = 0; k < modify->nfix; ++k) {
    if (FixBearingRing *r = dynamic_cast<FixBearingRing *>(modify->fix[k]))
      for (int i = 0; i < n; ++i)
        if (r->moves(i)) mover[i] = r;
    if (FixBearingCage *c = dynamic_cast<FixBearingCage *>(modify->fix[k]))
      for (const FixBearingCage::Rider &rider : c->riders()) join(rider.i, rider.i_ring);
  }
  std::vector<int> part(n, -1);
  auto of = [&](int i) -> ImplicitBearing & {
    if (!(atom->mask[i] & groupbit))
      BRG_ONE(std::string("fix ") + id + " bearing/implicit: atom " + std::to_string(atom->tag[i]) + " (type " +
              std::to_string(atom->type[i]) + ") belongs to a bearing of which other atoms are in the fix's group; "
              "put balls, cage balls and rings in the group");
    int &p = part[find(i)];
    if (p < 0) {
      p = static_cast<int>(parts_.size());
      parts_.push_back({ImplicitBearing(lmp, pair_), std::min(wish_, largest_)});
    }
    return parts_[p].bearing;
  };
  for (const bearing::RacewayContact &c : table.raceway) of(c.i_ball).add(c, mover[c.i_ring]);
  for (const bearing::SphereContact &s : table.sphere) of(s.i).add(s);
  for (int k = 0; k < modify->nfix; ++k)
    if (FixBearingCage *c = dynamic_cast<FixBearingCage *>(modify->fix[k]))
      for (size_t r = 0; r < c->riders().size(); ++r)
        of(c->riders()[r].i).add_rails(*c, r, mover[c->riders()[r].i_ring]);
  for (Part &p : parts_) p.bearing.finish();
  for (int i = 0; i < n; ++i)
    if ((atom->mask[i] & groupbit) && (part[find(i)] < 0 || !parts_[part[find(i)]].bearing.has(i)))
      BRG_ONE(std::string("fix ") + id + " bearing/implicit: atom " + std::to_string(atom->tag[i]) +
              " of its group is no ball, cage ball or ring of a bearing");
}

void FixBearingImplicit::initial_integrate(int)
{
  build();
  for (FixBearingRing *r : rings_) r->begin_step();
  for (Part &p : parts_) advance(p);
  time_ += update->dt;
}

// The host's step in equal substeps, as few as the control allows.
void FixBearingImplicit::advance(Part &p)
{
  const double whole = update->dt;
  p.bearing.load();
  double done = 0.0;
  while (done < whole) {
    const double left = whole - done;
    const double pieces = std::ceil(left / std::min(p.step, largest_) - 1e-9);
    const bool last = pieces <= 1.0;
    const double h = last ? left : left / pieces;
    const Outcome o = substep(p, h, last ? 1.0 : (done + h) / whole);
    // the miss of the predictor grows like h^2
    const double fit = 0.9 * std::sqrt(miss_ / std::max(o.miss, 1e-6 * miss_));
    if (!o.accepted) {
      refused_ += 1.0;
      p.step = h * std::min(0.5, std::max(0.2, o.solved ? fit : 0.25));
      if (p.step < smallest_step) give_up(h);
      continue;
    }
    substeps_ += 1.0;
    smallest_ = std::min(smallest_, h);
    worst_ = std::max(worst_, o.miss);
    // grow back where Newton had an easy time
    const double grow = std::min(2.0, std::max(0.5, fit));
    if (o.corrections <= (most_ + 1) / 2 && (grow < 1.0 || !last || h > 0.99 * p.step))
      p.step = std::min(grow * h, whole);
    done = last ? whole : done + h;
  }
  p.bearing.store();
}

// Newton's corrections until one is below the tolerance; a single one is the linearly implicit Euler step.
FixBearingImplicit::Outcome FixBearingImplicit::substep(Part &p, double h, double s)
{
  Outcome o;
  p.bearing.predict(h, s);
  while (o.corrections < most_) {
    const ImplicitBearing::Correction c = p.bearing.correct();
    ++o.corrections;
    corrections_ += 1.0;
    last_ = c.size;
    if (!c.sane) return o;
    if (o.corrections == 1) {
      o.miss = c.size;
      if (c.size > 4.0 * miss_) {    // no use to go on
        o.solved = true;
        return o;
      }
    }
    if (c.size > tolerance_ && most_ > 1) continue;
    o.solved = true;
    o.accepted = o.miss <= miss_;
    if (o.accepted) p.bearing.accept();
    return o;
  }
  return o;
}

void FixBearingImplicit::give_up(double h)
{
  BRG_ONE(std::string("fix ") + id + " bearing/implicit at step " + std::to_string(update->ntimestep) +
          ": no solution with substeps down to " + text(h) + " s; last correction " + text(last_) + " m, tolerance " +
          text(tolerance_) + " m. Load too high, rings apart, or the start overlaps");
  std::abort();
}

// Mean substep since the start of the run, s
double FixBearingImplicit::compute_scalar() { return compute_vector(0); }

// Since the start of the run: 1 mean and 2 smallest substep (s), 3 substeps, 4 corrections a substep, 5 refused
// substeps, 6 largest first correction (m)
double FixBearingImplicit::compute_vector(int k)
{
  const double n = std::max(substeps_, 1.0) / std::max<size_t>(parts_.size(), 1);
  const double values[] = {time_ / n, substeps_ > 0.0 ? smallest_ : 0.0, substeps_,
                           corrections_ / std::max(substeps_, 1.0), refused_, worst_};
  return values[k];
}

void FixBearingImplicit::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  double wish = wish_;
  for (const Part &p : parts_) wish = std::min(wish, p.step);
  const int size = sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&wish, sizeof(double), 1, fp);
}

void FixBearingImplicit::restart(char *buf) { memcpy(&wish_, buf, sizeof(double)); }
