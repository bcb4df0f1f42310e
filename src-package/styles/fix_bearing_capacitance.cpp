// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_capacitance.h"

#include "../core/figures/fix_columns.h"
#include "../core/settings/arguments.h"
#include "../core/settings/written.h"
#include "../ranks/gather.h"
#include "fixes.h"
#include "named_bearing.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::RacewayContact;
using bearing::tag_t;

// fix ID group bearing/capacitance [N] permittivity EPS [permittivity_at maximum|mean|two_thirds]
// [surroundings none|flooded|dry|cavitated [EPS_OUT]] [outlet EPS_OUT] [shoulders D_INNER D_OUTER]
// [roughness none|gamma] [background C] [film_floor H] [resistivity RHO] [frequency HZ]
// [strength E] [within M] [file F] [contacts F]
FixBearingCapacitance::FixBearingCapacitance(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/capacitance"))
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  nevery = 1;
  if (args.more() && args.next_is_number())
    nevery = args.integer("steps between samples", 1, 1000000000);
  else wait();
  said_ = bearing::joined(args.rest(), " ");
  idle_ = pair_->dry_by_choice();
  read_options(args);
  const bool all = model_.surrounded();
  if (!totals_name_.empty()) {
    std::string names = "step time capacitance largest_ball active_balls";
    if (all) names += " capacitance_total capacitance_total_top";
    if (ask_.any())
      for (int k = bearing::of_fix_capacitance::first_of_films; k < bearing::of_fix_capacitance::N;
           ++k)
        names += std::string(" ") + bearing::of_fix_capacitance::list[k].name;
    totals_.open(args, totals_name_, names.c_str(), world);
  }
  if (!contacts_name_.empty()) {
    std::string names = "step time ball raceway load h_c capacitance";
    if (all) names += " separation capacitance_outside capacitance_total";
    grooves_ = pair_->coefficients().many_grooves();
    if (grooves_) names += " groove";
    contacts_.open(args, contacts_name_, names.c_str(), world);
  }
  bearing::provide_values(*this, bearing::of_fix_capacitance::N, nevery);
  peratom_flag = 1;
  size_peratom_cols = all ? 6 : 3;
  peratom_freq = nevery;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
}

void FixBearingCapacitance::read_options(Arguments &args)
{
  while (args.more()) {
    if (args.within("permittivity", model_.permittivity,
                    "relative permittivity at ambient pressure", 1.0, 10.0) ||
        args.variable("outlet", model_.permittivity_outlet) ||
        args.non_negative("background", background_, "background capacitance (F)") ||
        args.positive("film_floor", model_.film_floor, "thinnest film of a capacitor (m)") ||
        args.positive("resistivity", ask_.resistivity, "resistivity of the lubricant (ohm m)") ||
        args.positive("frequency", ask_.frequency, "frequency of the impedance (Hz)") ||
        args.positive("strength", ask_.strength, "dielectric strength of a film (V/m)") ||
        args.integer("within", within_, "instants per step", 1, 100000) ||
        args.word("file", totals_name_, "name of the file") ||
        args.word("contacts", contacts_name_, "name of the file for contacts"))
      continue;
    if (args.take("permittivity_at")) {
      model_.at = static_cast<PermittivityAt>(
          args.choice("permittivity_at", {"maximum", "mean", "two_thirds"}));
    } else if (args.take("surroundings")) {
      model_.surroundings = static_cast<Surroundings>(
          args.choice("surroundings", {"none", "flooded", "dry", "cavitated"}));
      if (model_.surroundings == Surroundings::cavitated && args.next_is_number())
        model_.permittivity_outlet = args.number_of("outlet");
    } else if (args.non_negative("shoulders", model_.inner_shoulder,
                                 "shoulder diameter of the inner ring (m)")) {
      model_.outer_shoulder = args.non_negative("shoulder diameter of the outer ring (m)");
    } else if (args.take("roughness")) {
      model_.rough = args.choice("roughness", {"none", "gamma"}) == 1;
    } else {
      args.unknown();
    }
  }
  bearing::check_within(args, within_, nevery);
  if (idle_) return;
  given_ = model_;
  said_given_ = said_;
  take_usual_data();
  if (model_.permittivity == 0.0) args.fail("'permittivity EPS' is missing");
  if (model_.surroundings == Surroundings::cavitated &&
      model_.permittivity_outlet > model_.permittivity)
    args.fail("'surroundings cavitated': relative permittivity of the outlet is " +
              bearing::text(model_.permittivity_outlet) + ", must be from 1 to the lubricant's, " +
              bearing::text(model_.permittivity));
  if (!pair_->coefficients().lubricated())
    args.fail("a dry contact has no capacitance: use pair_style bearing/ehd");
}

FixBearingCapacitance::~FixBearingCapacitance()
{
  atom->delete_callback(id, 0);
  memory->destroy(per_ball_);
}

// Takes settings from the pair style if it defines a named bearing and its oil, which may change
// from run to run.
void FixBearingCapacitance::take_usual_data()
{
  model_ = given_;
  said_ = said_given_;
  const std::vector<int> there = ball_types();
  const auto usual = [&](double &value, const char *what, const auto &of) {
    if (value != 0.0) return;
    for (int type = 1; type <= atom->ntypes; ++type) {
      if (!there[type] || of(type) == 0.0) continue;
      if (value != 0.0 && value != of(type))
        BRG_ALL(bearing::name_of(*this) + ": its balls have more than one " + what +
                ": use a separate fix for each bearing, or specify the value");
      value = of(type);
    }
  };
  const bool shoulders = model_.inner_shoulder != 0.0 || model_.outer_shoulder != 0.0,
             permittivity = model_.permittivity != 0.0;
  usual(model_.permittivity, "permittivity", [this](int t) { return pair_->permittivity(t); });
  usual(model_.inner_shoulder, "shoulder diameter",
        [this](int t) { return pair_->shoulder(t, Side::inner); });
  usual(model_.outer_shoulder, "shoulder diameter",
        [this](int t) { return pair_->shoulder(t, Side::outer); });
  if (!permittivity)
    said_ =
        "permittivity " + bearing::digits(model_.permittivity) + (said_.empty() ? "" : " ") + said_;
  if (!shoulders && (model_.inner_shoulder != 0.0 || model_.outer_shoulder != 0.0))
    said_ += " shoulders " + bearing::digits(model_.inner_shoulder) + " " +
             bearing::digits(model_.outer_shoulder);
}

int FixBearingCapacitance::setmask() { return idle_ ? 0 : END_OF_STEP; }

// Sets the sampling interval to that of the run. Stops with an error if the run samples less often
// than `within` requires.
void FixBearingCapacitance::begin(const bearing::Sampling &sampling)
{
  if (within_ > 1 && sampling.every > 1)
    BRG_ALL(bearing::name_of(*this) + ": 'within' takes samples evenly within every step, but a " +
            "sample of this run takes " + std::to_string(sampling.every) + " steps");
  nevery = global_freq = peratom_freq = sampling.every;
}

void FixBearingCapacitance::init()
{
  if (idle_) return;
  if (waits()) return refuse_plain_run(lmp, bearing::name_of(*this));
  pair_ = PairBearingHertz::find(lmp, "fix bearing/capacitance");
  take_usual_data();
  if (model_.permittivity == 0.0)
    BRG_ALL(bearing::name_of(*this) + ": 'permittivity EPS' is missing");
  planned_ = -1;
  filled_ = -1;
  const std::vector<int> there = ball_types();
  int balls = 0;
  for (int type = 1; type <= atom->ntypes; ++type)
    balls += there[type] && pair_->coefficients().is_ball(type);
  if (balls == 0)
    BRG_ALL(bearing::name_of(*this) + ": group " + group->names[igroup] + " has no balls");
  pair_->add_capacitor(groupbit, model_);
  if (model_.surrounded()) check_shoulders();
  for (int type = 1; type <= atom->ntypes; ++type) {
    const bearing::NamedBearing *const b =
        there[type] ? bearing::bearing_of_type(lmp, type) : nullptr;
    if (b && b->word("ball_material") != "steel" && insulating_.insert(b->name).second &&
        comm->me == 0)
      BRG_WARN(bearing::name_of(*this) + ": the balls of bearing " + b->name + " are of " +
               b->word("ball_material") + ", which insulates, but the capacitances are those of " +
               "balls of steel");
  }
}

// Returns the atom types in the group, which are the same on all ranks.
std::vector<int> FixBearingCapacitance::ball_types() const
{
  std::vector<int> there(atom->ntypes + 1, 0);
  for (int i = 0; i < atom->nlocal; ++i)
    if (covers(i)) there[atom->type[i]] = 1;
  MPI_Allreduce(MPI_IN_PLACE, there.data(), atom->ntypes + 1, MPI_INT, MPI_MAX, world);
  return there;
}

// Checks the shoulders of all raceways on which balls of the group may run.
void FixBearingCapacitance::check_shoulders()
{
  const std::vector<int> there = ball_types();
  for (int ball = 1; ball <= atom->ntypes; ++ball)
    for (int ring = 1; ring <= atom->ntypes; ++ring) {
      const RacewayPhysics *p = there[ball] ? pair_->coefficients().raceway(ball, ring) : nullptr;
      if (!p) continue;
      const std::string who = bearing::name_of(*this) + ": ";
      const bool inner = p->groove.side == Side::inner;
      const double bottom = 2.0 * p->groove.raceway_radius,
                   centre = bottom + (inner ? 2.0 : -2.0) * p->groove.ball_radius,
                   depth = model_.groove_depth(p->groove);
      if (!(depth > 0.0 && depth < p->groove.ball_radius))
        BRG_ALL(who + "shoulder diameter of the " + (inner ? "inner" : "outer") + " ring is " +
                bearing::text(inner ? model_.inner_shoulder : model_.outer_shoulder) +
                " m; it must lie between the raceway, " + bearing::text(bottom) +
                " m, and the ball's centre, " + bearing::text(centre) + " m");
      if (p->model.ellipse == Ellipse::printed)
        BRG_ALL(who + "'surroundings' needs 'ellipse exact' or 'hamrock' in the pair style: "
                      "'printed' does not match the gap outside the ellipse");
    }
}

void FixBearingCapacitance::setup(int)
{
  if (waits() || idle_) return;
  if (within_ > 1) find_integrators();
  sample(false);
}

void FixBearingCapacitance::end_of_step()
{
  if (!waits()) sample(true);
}

// Finds the integrators that provide the instants, and the balls of these integrators that belong
// to the group.
void FixBearingCapacitance::find_integrators()
{
  integrators_ = bearing::fixes_of<bearing::InstantSource>(lmp);
  if (integrators_.empty())
    BRG_ALL(bearing::name_of(*this) + ": 'within " + std::to_string(within_) +
            "' needs fix bearing/implicit, which provides the states within a step; with other "
            "integrators sample every step");
  for (bearing::InstantSource *f : integrators_)
    f->want_instants(instants(within_), bearing::name_of(*this));
  members_ = bearing::TagSet(find_members());
}

std::vector<tag_t> FixBearingCapacitance::find_members() const
{
  std::vector<tag_t> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) mine.push_back(atom->tag[i]);
  return bearing::gather_all(mine, world);
}

FilmCapacitorT<double> FixBearingCapacitance::capacitor(const RacewayContact &c)
{
  if (!model_.surrounded())
    return c.live ? film_capacitor(*c.raceway, c.state, model_) : FilmCapacitorT<double>{};
  const bearing::ContactTable &table = pair_->table();
  if (planned_ != pair_->table_build()) {
    planned_ = pair_->table_build();
    filled_ = -1;
    table_.plan(table, model_, [this](const RacewayContact &one) { return covers(one.i_ball); });
  }
  if (filled_ != pair_->table_fill()) {
    filled_ = pair_->table_fill();
    table_.fill(table);
  }
  return table_[static_cast<size_t>(&c - table.raceway.data())];
}

FixBearingCapacitance::Row FixBearingCapacitance::row_of(int instant, tag_t ball,
                                                         const RacewayPhysics &raceway, bool live,
                                                         double load, const ContactState &state,
                                                         const FilmCapacitorT<double> &of) const
{
  Row row = {instant, ball, raceway.groove.side, raceway.number, live, live ? load : 0.0, of,
             0.0,     0.0};
  if (!ask_.any()) return row;
  row.roughness = raceway.roughness;
  if (live) row.area = hertz_area(raceway, state);
  return row;
}

// Adds the instants within the step for the bearings whose home is on this rank.
void FixBearingCapacitance::add_instants()
{
  for (bearing::InstantSource *f : integrators_)
    for (int k = 1; k < within_; ++k)
      f->read_instant(k, {[this, k](const bearing::InstantContact &c) {
                            if ((c.live || model_.surrounded()) && members_.has(c.ball))
                              mine_.push_back(row_of(k, c.ball, c.raceway, c.live, c.load, c.state,
                                                     c.capacitor));
                          },
                          {},
                          {}});
}

// Samples the balls owned by this rank. Sums over all ranks are computed only on request, because a
// table of values per ring does not need them.
void FixBearingCapacitance::sample(bool between)
{
  mine_.clear();
  if (between) add_instants();
  for (int i = 0; i < atom->nlocal; ++i) set_arrays(i);
  for (const RacewayContact &c : pair_->table().raceway)
    if ((c.live || model_.surrounded()) && covers(c.i_ball)) {
      const FilmCapacitorT<double> q = capacitor(c);
      const int s = c.side() == Side::inner ? 0 : 1;
      per_ball_[c.i_ball][s] += q.capacitance;
      if (model_.surrounded()) per_ball_[c.i_ball][3 + s] += q.total();
      mine_.push_back(row_of(within_, c.ball, *c.raceway, c.live, c.state.load, c.state, q));
    }
  for (int i = 0; i < atom->nlocal; ++i)
    for (int k = 0; k < size_peratom_cols; k += 3)
      per_ball_[i][k + 2] = series_capacitance(per_ball_[i][k], per_ball_[i][k + 1]);
  between_ = between;
  summed_ = false;
  if (totals_.wanted() || contacts_.wanted()) sum_up();
}

void FixBearingCapacitance::grow_arrays(int n)
{
  memory->grow(per_ball_, n, size_peratom_cols, "bearing/capacitance:per_ball");
  array_atom = per_ball_;
}

void FixBearingCapacitance::copy_arrays(int i, int j, int)
{
  for (int k = 0; k < size_peratom_cols; ++k) per_ball_[j][k] = per_ball_[i][k];
}

void FixBearingCapacitance::set_arrays(int i)
{
  std::fill(per_ball_[i], per_ball_[i] + size_peratom_cols, 0.0);
}

double FixBearingCapacitance::memory_usage()
{
  return double(size_peratom_cols) * atom->nmax * sizeof(double);
}

std::vector<FixBearingCapacitance *> bearing::capacitances_of(LAMMPS *lmp)
{
  std::vector<FixBearingCapacitance *> list;
  for (FixBearingCapacitance *f : fixes_of<FixBearingCapacitance>(lmp))
    if (!f->idle()) list.push_back(f);
  return list;
}
