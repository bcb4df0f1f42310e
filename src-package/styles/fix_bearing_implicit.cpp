// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_implicit.h"

#include "../deck/arguments.h"
#include "fix_bearing_ring.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::ImplicitBearing;
using bearing::tag_t;
using bearing::text;

static constexpr double smallest_step = 1e-12;    // s

// fix ID group bearing/implicit [solve all|damping] [tolerance T] [order 1|2] [corrections N]
// [largest H] [creep C] [energy yes|no]
FixBearingImplicit::FixBearingImplicit(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/implicit")),
    bearings_(lmp, std::string("fix ") + id + " bearing/implicit")
{
  Arguments args(lmp, std::string("fix ") + id + " bearing/implicit", narg, arg, 3);
  while (args.more()) {
    if (args.take("tolerance")) tolerance_ = args.within("tolerance (m)", 1e-13, 1e-4);
    else if (args.take("solve")) settings_.dampers_only = args.choice("solve", {"all", "damping"});
    else if (args.take("order")) settings_.order = args.integer("order", 1, 2);
    else if (args.take("corrections"))
      settings_.corrections = args.integer("corrections in a stage", 1, 100);
    else if (args.take("largest")) largest_ = args.positive("largest step (s)");
    else if (args.take("creep")) creep_ = args.within("creep of the smoothed friction", 1e-6, 1.0);
    else if (args.take("energy")) energy_wanted_ = args.choice("energy", {"no", "yes"});
    else args.unknown("solve, tolerance, order, corrections, largest, creep, energy");
  }
  if (tolerance_ == 0.0) tolerance_ = settings_.dampers_only ? 1e-7 : 1e-9;
  settings_.newton = tolerance_;
  time_integrate = 1;
  scalar_flag = vector_flag = 1;
  size_vector = 10;
  global_freq = 1;
  extscalar = extvector = 0;
}

int FixBearingImplicit::setmask() { return INITIAL_INTEGRATE; }

void FixBearingImplicit::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/implicit");
  check_fixes();
  find_rings();
  instants_ = Instants();
  if (pair_->smooth_friction(creep_) && comm->me == 0) {
    const std::string say = std::string("fix ") + id +
                            " bearing/implicit: friction smoothed over a creep of " + text(creep_) +
                            " of the entrainment speed\n";
    if (screen) fputs(say.c_str(), screen);
    if (logfile) fputs(say.c_str(), logfile);
  }
}

// Fixes whose rings are in the group: the same list on all ranks, which own different rings or
// none.
void FixBearingImplicit::find_rings()
{
  std::vector<FixBearingRing *> all;
  std::vector<int> seen;    // two a fix: rings in the group, rings outside
  for (int k = 0; k < modify->nfix; ++k)
    if (FixBearingRing *r = dynamic_cast<FixBearingRing *>(modify->fix[k])) {
      int mine = 0, others = 0;
      for (int i = 0; i < atom->nlocal; ++i)
        if (r->moves(i)) (atom->mask[i] & groupbit ? mine : others) = 1;
      all.push_back(r);
      seen.push_back(mine);
      seen.push_back(others);
    }
  MPI_Allreduce(MPI_IN_PLACE, seen.data(), static_cast<int>(seen.size()), MPI_INT, MPI_MAX, world);
  rings_.clear();
  for (size_t k = 0; k < all.size(); ++k) {
    if (!seen[2 * k]) continue;
    if (seen[2 * k + 1])
      BRG_ALL(std::string("fix ") + id + " bearing/implicit: its group has some rings of fix " +
              all[k]->id + " but not all of them");
    rings_.push_back(all[k]);
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
            BRG_ONE(std::string("fix ") + id + " bearing/implicit and fix " + f.id +
                    " both move atom " + std::to_string(atom->tag[i]));
      continue;
    }
    const char *does = f.time_integrate                ? "moves them too"
                       : modify->fmask[k] & POST_FORCE ? "adds forces that "
                                                         "an implicit step does not see"
                                                       : nullptr;
    for (int i = 0; does && i < atom->nlocal; ++i)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & f.groupbit))
        BRG_ONE(std::string("fix ") + id + " bearing/implicit: its group has atoms of fix " + f.id +
                " (" + f.style + "), which " + does);
  }
}

void FixBearingImplicit::setup(int)
{
  build_ = -1;
  substeps_ = corrections_ = refused_ = time_ = worst_ = 0.0;
  energy_ = raceway::BearingStep::Energy();
  begun_ = false;
  smallest_ = HUGE_VAL;
}

void FixBearingImplicit::build()
{
  if (build_ == pair_->table_build()) return;
  build_ = pair_->table_build();
  for (Part &p : parts_) {    // what the bearings of the last build have to say
    energy_.work += p.bearing.step().spent().work;
    energy_.dissipated += p.bearing.step().spent().dissipated;
  }
  bearings_.build(pair_, groupbit);
  parts_.clear();
  for (int p = 0; p < bearings_.size(); ++p) {
    parts_.push_back({ImplicitBearing(*pair_, bearings_.model(p)), 0.0});
    parts_.back().bearing.step().keep_energy(energy_wanted_);
    parts_.back().bearing.step().instants().want(instants_);
  }
}

// What is stored before the first step of a run.
void FixBearingImplicit::begin_energy()
{
  stored_before_ = 0.0;
  for (Part &p : parts_) stored_before_ += p.bearing.step().energy().stored;
  MPI_Allreduce(MPI_IN_PLACE, &stored_before_, 1, MPI_DOUBLE, MPI_SUM, world);
  begun_ = true;
}

void FixBearingImplicit::initial_integrate(int)
{
  build();
  for (FixBearingRing *r : rings_) r->begin_step();
  bearings_.gather();
  for (int p = 0; p < bearings_.size(); ++p)
    parts_[p].bearing.load(bearings_.bodies(p), bearings_.rings(p));
  if (energy_wanted_ && !begun_) begin_energy();
  for (int p = 0; p < bearings_.size(); ++p) {
    // the control's wish is kept with the ring, so that it goes with the bearing to another home or
    // into a restart file
    double &wish = bearings_.rings(p).front().motion.step;
    parts_[p].step = wish > 0.0 ? wish : largest_;
    advance(parts_[p]);
    wish = parts_[p].step;
    parts_[p].bearing.store(bearings_.bodies(p), bearings_.rings(p));
  }
  bearings_.scatter();
  time_ += update->dt;
}

// The host's step in equal substeps, as few as the control allows.
void FixBearingImplicit::advance(Part &p)
{
  const double whole = update->dt;
  raceway::BearingStep &bearing = p.bearing.step();
  double done = 0.0;
  while (done < whole) {
    const double left = whole - done;
    const double pieces = std::ceil(left / std::min(p.step, largest_) - 1e-9);
    const bool last = pieces <= 1.0;
    const double h = last ? left : left / pieces;
    const raceway::BearingStep::Outcome o =
        bearing.step(settings_, h, done / whole, last ? 1.0 : (done + h) / whole);
    corrections_ += o.corrections;
    // over what is allowed; grows like h^2
    const double excess = std::max(o.error / tolerance_, o.stability);
    const double fit = 0.9 / std::sqrt(std::max(excess, 1e-6));
    if (!o.solved() || !(excess <= 1.0)) {
      refused_ += 1.0;
      p.step = h * std::min(0.5, std::max(0.2, o.solved() ? fit : 0.25));
      if (p.step < smallest_step) give_up(p, h, o);
      continue;
    }
    bearing.accept();
    substeps_ += 1.0;
    smallest_ = std::min(smallest_, h);
    worst_ = std::max(worst_, o.error);
    // grow back where Newton had an easy time
    const double grow = std::min(2.0, std::max(0.5, fit));
    if (o.corrections <= settings_.corrections && (grow < 1.0 || !last || h > 0.99 * p.step))
      p.step = std::min(grow * h, whole);
    done = last ? whole : done + h;
  }
}

void FixBearingImplicit::want_instants(const Instants &i)
{
  if (instants_.number > 1 &&
      (i.number != instants_.number || i.eps != instants_.eps || i.shortest != instants_.shortest))
    BRG_ALL(
        std::string("fix ") + id +
        " bearing/implicit: two fixes want different things between its steps; give them the same "
        "'within', permittivity and film_floor");
  instants_ = i;
}

void FixBearingImplicit::add_instants(const std::vector<tag_t> &of,
                                      std::vector<InstantContact> &add) const
{
  std::vector<int> wanted;    // grooves
  for (int p = 0; p < static_cast<int>(parts_.size()); ++p) {
    const bearing::PartModel &m = bearings_.model(p);
    wanted.clear();
    for (int g = 0; g < static_cast<int>(m.grooves.size()); ++g)
      if (std::binary_search(of.begin(), of.end(), m.bodies[m.grooves[g].body].tag))
        wanted.push_back(g);
    for (int k = 1; k < instants_.number; ++k)
      for (int g : wanted) {
        const raceway::InstantLoad c = parts_[p].bearing.step().instants().at(k, g);
        if (c.load > 0.0)
          add.push_back({k, m.bodies[m.grooves[g].body].tag, m.grooves[g].physics->groove.side, c});
      }
  }
}

static std::string cause(raceway::Failure f, const std::string &who)
{
  using raceway::Failure;
  switch (f) {
    case Failure::not_a_number: return "the velocity of " + who + " is not a number";
    case Failure::outside_groove: return "the overlap of " + who + " is beyond the overlap limit";
    case Failure::turned_too_far: return "a body turns too far for one stage";
    case Failure::other_links: return "cage contacts open and close between corrections";
    default: return "corrections do not converge";
  }
}

void FixBearingImplicit::give_up(Part &p, double h, const raceway::BearingStep::Outcome &o)
{
  const std::string where =
      std::string("fix ") + id + " bearing/implicit at step " + std::to_string(update->ntimestep);
  const std::string who =
      o.body >= 0 ? "atom " + std::to_string(p.bearing.tag(o.body)) : std::string("a body");
  if (o.failure == raceway::Failure::overlinked)
    BRG_ONE(where + ": " + who + " touches more than two balls or cage balls");
  BRG_ONE(where + ": no solution with substeps down to " + text(h) + " s; last correction " +
          text(o.last) + " m, estimated error " + text(o.error) + " m, tolerance " +
          text(tolerance_) + " m; " +
          (o.solved() ? "the error is too large" : cause(o.failure, who)) +
          ". Load too high, rings apart, or the start overlaps");
  std::abort();
}

// Mean substep since the start of the run, s
double FixBearingImplicit::compute_scalar() { return compute_vector(0); }

// Since the start of the run: 1 mean and 2 smallest substep (s), 3 substeps, 4 corrections a
// substep, 5 refused substeps, 6 largest estimated error (m); with energy yes: 7 work put in, 8
// dissipated, 9 growth of what is stored, 10 lost by the integrator, 7 - 8 - 9 (J)
double FixBearingImplicit::compute_vector(int k)
{
  raceway::BearingStep::Energy e = energy_;
  for (Part &p : parts_)
    if (energy_wanted_) {
      const raceway::BearingStep::Energy &now = p.bearing.step().energy();
      e.work += now.work;
      e.dissipated += now.dissipated;
      e.stored += now.stored;
    }
  double sum[] = {substeps_, corrections_, refused_, static_cast<double>(parts_.size()),
                  e.work,    e.dissipated, e.stored};
  double most[] = {worst_, -smallest_};
  MPI_Allreduce(MPI_IN_PLACE, sum, 7, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, world);
  const double n = std::max(sum[0], 1.0), bearings = std::max(sum[3], 1.0),
               stored = sum[6] - stored_before_;
  const double values[] = {time_ * bearings / n,
                           sum[0] > 0.0 ? -most[1] : 0.0,
                           sum[0],
                           sum[1] / n,
                           sum[2],
                           most[0],
                           sum[4],
                           sum[5],
                           energy_wanted_ ? stored : 0.0,
                           energy_wanted_ ? sum[4] - sum[5] - stored : 0.0};
  return values[k];
}
