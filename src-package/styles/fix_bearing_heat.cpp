// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_heat.h"

#include "../core/geometry/ring_capacity.h"
#include "../core/geometry/usual_data.h"
#include "../core/numbers/number_list.h"
#include "../core/settings/arguments.h"
#include "../core/settings/deck_variable_table.h"
#include "ball_pass.h"
#include "fix_bearing_cage_ring.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_ring.h"
#include "fixes.h"
#include "named_bearing.h"
#include "pair_bearing.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace raceway;
using bearing::Arguments;
using bearing::text;
namespace of = bearing::of_fix_heat;

static constexpr double samples_a_pass = 200.0;    // maximum number of samples per ball pass

// fix ID group bearing/heat [heat yes|no] [ambient T] [cooling G] [shaft_cooling G] [seat G]
// [housing_capacity C] [oil_flow Q] [oil_inlet T] [warm_start T] [warm_time S] [warm_change K]
// [warm_error K] [file NAME]
FixBearingHeat::FixBearingHeat(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  std::string heat = "yes";
  network_.ambient = bearing::usual_number("ambient");
  control_.change = bearing::usual_number("warm_change");
  control_.error = bearing::usual_number("warm_error");
  while (args.more())
    if (!(args.variable("heat", heat) || args.variable("ambient", network_.ambient) ||
          args.variable("cooling", cooling_) || args.variable("shaft_cooling", network_.shaft) ||
          args.variable("seat", network_.seat) ||
          args.variable("housing_capacity", network_.capacity[3]) ||
          args.variable("oil_flow", oil_flow_) || args.variable("oil_inlet", oil_inlet_) ||
          args.variable("warm_start", start_) || args.variable("warm_time", control_.until) ||
          args.variable("warm_change", control_.change) ||
          args.variable("warm_error", control_.error) ||
          args.word("file", file_name_, "name of the file")))
      args.unknown();
  idle_ = heat == "no";
  if (network_.capacity[3] > 0.0 && network_.seat == 0.0)
    args.fail("'housing_capacity' needs 'seat', the conductance from outer ring to housing");
  if (!std::isnan(oil_inlet_) && oil_flow_ == 0.0)
    args.fail("'oil_inlet' needs 'oil_flow', the volume flow of the oil");
  restart_global = 1;
  bearing::provide_values(*this, bearing::of_fix_heat::N);
  nevery = 1;
  if (idle_ || file_name_.empty()) return;
  std::string names;
  for (const auto &column : of::list)
    names += (names.empty() ? "" : " ") + std::string(column.name);
  file_.open(args, file_name_, names.c_str(), world);
}

int FixBearingHeat::setmask() { return idle_ ? 0 : INITIAL_INTEGRATE | END_OF_STEP; }

void FixBearingHeat::init()
{
  if (idle_) return;
  pair_ = dynamic_cast<PairBearing *>(force->pair);
  if (!pair_)
    BRG_ALL(bearing::name_of(*this) +
            " needs pair_style bearing, which provides the sizes of the bearing and its oil");
  find_bearing();
  check_oil();
  find_network();
  const auto rings = bearing::fixes_of<FixBearingRing>(lmp);
  varies_ = std::any_of(rings.begin(), rings.end(), [](auto *f) { return !f->constant(); });
  // a speed that varies must not change the time of a ball pass wherever a run is divided
  if (now_.pass == 0.0 || !varies_)
    now_.pass = bearing::ball_pass_time(lmp, bearing::name_of(*this), NAN);
  pair_->add_follower(this);
  HeatState &heat = now_.heat;
  if (now_.begun == 0.0) {
    now_.begun = 1.0;
    const double start = std::isnan(start_) ? network_.ambient : start_;
    for (int k = 0; k < heat_nodes; ++k) heat.at[k] = heat.law[k] = start;
    if (network_.capacity[3] > 0.0) heat.at[3] = heat.law[3] = network_.ambient;
    std::copy_n(heat.law, parts, now_.from);
    std::copy_n(heat.law, parts, now_.to);
    std::copy_n(heat.at, heat_nodes, now_.begin);
    for (const char *cold : {"paper", "film", "none"})
      if (pair_->models() == cold && comm->me == 0)
        BRG_WARN(bearing::name_of(*this) + ": models " + cold +
                 " have no full-film friction and therefore generate little heat; use models full");
    now_.oil = heat.oil();
  }
  apply_oil();
  apply_ = false;
}

// Finds the named bearing to which the group's balls belong, and the number of bearings with that
// name.
void FixBearingHeat::find_bearing()
{
  std::vector<int> there(atom->ntypes + 1, 0);
  for (int i = 0; i < atom->nlocal; ++i)
    if ((atom->mask[i] & groupbit) && pair_->coefficients().is_ball(atom->type[i]))
      there[atom->type[i]] = 1;
  MPI_Allreduce(MPI_IN_PLACE, there.data(), atom->ntypes + 1, MPI_INT, MPI_MAX, world);
  bearing_ = nullptr;
  for (int type = 1; type <= atom->ntypes; ++type) {
    if (!there[type]) continue;
    const bearing::NamedBearing *of = bearing::bearing_of_type(lmp, type);
    if (!of)
      BRG_ALL(bearing::name_of(*this) + ": balls of type " + std::to_string(type) +
              " do not belong to a bearing with a name");
    if (bearing_ && of != bearing_)
      BRG_ALL(bearing::name_of(*this) + ": its balls belong to bearings " + bearing_->name +
              " and " + of->name + ": give each its own fix");
    bearing_ = of;
  }
  if (!bearing_) BRG_ALL(bearing::name_of(*this) + ": there is no ball in its group");
  for (const FixBearingHeat *f : bearing::fixes_of<FixBearingHeat>(lmp))
    if (f != this && !f->idle_ && f->bearing_ == bearing_)
      BRG_ALL(bearing::name_of(*this) + " and fix " + f->id + " both heat bearing " +
              bearing_->name);
  int count[3] = {};    // inner rings; balls of the bearing, and those that are in the group
  for (int i = 0; i < atom->nlocal; ++i) {
    count[0] += atom->type[i] == bearing_->inner;
    count[1] += atom->type[i] == bearing_->balls;
    count[2] += atom->type[i] == bearing_->balls && (atom->mask[i] & groupbit);
  }
  MPI_Allreduce(MPI_IN_PLACE, count, 3, MPI_INT, MPI_SUM, world);
  if (count[2] < count[1])
    BRG_ALL(bearing::name_of(*this) + ": group " + group->names[igroup] + " has only " +
            std::to_string(count[2]) + " of the " + std::to_string(count[1]) +
            " balls of bearing " + bearing_->name +
            ", but its temperatures are those of every bearing with this name: use group all, or "
            "name each bearing");
  bearings_ = count[0];
}

void FixBearingHeat::check_oil()
{
  dry_ = !pair_->coefficients().lubricated();
  if (!dry_ && !pair_->oil_follows(bearing_->name))
    BRG_ALL(bearing::name_of(*this) + ": the oil " + pair_->oil() + " of bearing " +
            bearing_->name +
            " has no data over temperature: take vg46, for example, and after a restart file give "
            "pair_style and pair_coeff again");
  if (dry_ && oil_flow_ > 0.0)
    BRG_ALL(bearing::name_of(*this) + ": 'oil_flow' needs oil, but bearing " + bearing_->name +
            " is dry");
}

// Computes conductances and heat capacities from the dimensions of the bearing.
void FixBearingHeat::find_network()
{
  const bearing::NamedBearing &b = *bearing_;
  std::string missing;
  for (const char *size : {"bore_diameter", "outside_diameter", "bearing_width"})
    if (!(b.number_or(size, 0.0) > 0.0))
      missing += (missing.empty() ? "" : ", ") + std::string(size);
  if (!missing.empty())
    BRG_ALL(bearing::name_of(*this) + ": bearing " + b.name + " has no " + missing +
            ", which determines the heat capacities of its rings; specify the data with -var");
  const double bore = b.number("bore_diameter"), outside = b.number("outside_diameter"),
               width = b.number("bearing_width");
  const auto or_steel = [&b](const char *name, double steel) {
    return b.number(name) > 0.0 ? b.number(name) : steel;
  };
  network_.housing = cooling_ > 0.0 ? cooling_ : iso_15312_conductance(bore, outside, width);
  for (const RacewayPhysics *p : pair_->coefficients().raceways_under(b.balls)) {
    if (p->number > 0) continue;
    const bool inner = p->groove.side == Side::inner;
    double shoulder =
        b.number_or(inner ? "inner_shoulder_diameter" : "outer_shoulder_diameter", 0.0);
    if (shoulder == 0.0) {
      const double depth =
          RingCylinder::shoulder(0.0, 2.0 * p->groove.ball_radius);    // depth of a groove
      shoulder = 2.0 * (p->groove.raceway_radius + (inner ? depth : -depth));
    }
    network_.capacity[inner ? 0 : 2] =
        ring_capacity(p->groove, inner ? bore : outside, shoulder, width);
    network_.capacity[1] =
        b.number("balls") * p->ball_mass * or_steel("ball_heat_capacity", steel_heat);
  }
  ball_ = {1.0, or_steel("ball_expansion", steel_expansion) / steel_expansion};
  if (b.number("ball_conductivity") > 0.0 || b.number("ball_heat_capacity") > 0.0)
    ball_.effusivity =
        effusivity_of_balls(or_steel("ball_conductivity", steel_conductivity),
                            b.number("ball_density"), or_steel("ball_heat_capacity", steel_heat));
  if (oil_flow_ > 0.0) find_oil_flow();
}

// Sets the mass flow, which follows from the volume flow and the density at 40 C.
void FixBearingHeat::find_oil_flow()
{
  const bearing::NamedBearing &b = *bearing_;
  const WettedSurfaces wets = wetted_surfaces(
      b.number("b_inner_raceway"), b.number("b_outer_raceway"), 0.5 * b.number("ball_diameter"),
      b.number("balls"), b.number("bearing_width"));
  OilFlow &oil = network_.oil;
  oil.flow = oil_flow_ * oil_datum("oil_density_40") * oil_datum("oil_heat_capacity");
  oil.inlet = std::isnan(oil_inlet_) ? network_.ambient : oil_inlet_;
  oil.wetted[0] = wets.inner;
  oil.wetted[1] = wets.balls;
  oil.wetted[2] = wets.outer;
}

// Returns a property of the bearing's oil at its current temperature.
double FixBearingHeat::oil_datum(const char *name) const
{
  return std::atof(pair_->oil_datum(bearing_->name, name).c_str());
}

// Returns the heat transfer coefficient of the oil in W/(m^2 K).
double FixBearingHeat::convection() const
{
  if (!network_.oil.flows()) return 0.0;
  const double pitch = bearing_->number("b_inner_raceway") + bearing_->number("b_outer_raceway"),
               orbit = 2.0 * 3.14159265358979323846 / (bearing_->number("balls") * now_.pass);
  return oil_convection(oil_datum("oil_conductivity"), oil_datum("oil_heat_capacity"),
                        oil_datum("oil_density"), oil_datum("viscosity"), orbit, pitch);
}

// Finds the time until the end of the load ramp.
void FixBearingHeat::setup(int)
{
  if (idle_) return;
  ramp_ = 0.0;
  for (const FixBearingRing *f : bearing::fixes_of<FixBearingRing>(lmp))
    ramp_ = std::max(ramp_, f->ramp());
  stride_ = std::max(1, static_cast<int>(now_.pass / update->dt / samples_a_pass));
  if (rewrite_) {    // these rows had been written before the restart file was
    rewrite_ = false;
    if (FILE *f = file_.file(); f)
      for (const Row &row : rows_) write_row(row);
  }
  last_step_ = -1;
  together_.clear();
  for (FixBearingHeat *f : bearing::fixes_of<FixBearingHeat>(lmp)) {
    if (f->idle_) continue;
    together_.push_back(f);
    if (f->control_.until != control_.until)
      BRG_ALL(bearing::name_of(*this) + ": warm_time is " + text(control_.until) +
              " s, but that of fix " + f->id + " is " + text(f->control_.until) +
              " s; all bearings share one thermal clock");
  }
}

void FixBearingHeat::begin_step()
{
  if (last_step_ == update->ntimestep) return;
  last_step_ = update->ntimestep;
  ahead_ = update->dt;
  if (apply_) apply_oil();
  apply_ = false;
  if (now_.stage == RAMP || now_.stage == LAST) grow(share_at(now_.since + ahead_));
}

// Adapts contact law and cage to the temperature of the oil, and sets the thermal expansion of the
// surfaces.
void FixBearingHeat::apply_oil()
{
  if (!dry_) {
    pair_->set_oil_temperature(Arguments(lmp, bearing::name_of(*this), {}), bearing_->name,
                               now_.oil);
    for (FixBearingCageRing *f : bearing::fixes_of<FixBearingCageRing>(lmp)) f->take_oil();
  }
  // a new contact law has the sizes of cold parts, in every bearing
  for (FixBearingHeat *f : bearing::fixes_of<FixBearingHeat>(lmp)) {
    if (f->idle_ || !f->bearing_) continue;
    f->pair_ = pair_;    // the pair style may be a new one, which f learns only in its own init()
    const bool moves = f->now_.stage == RAMP || f->now_.stage == LAST;
    f->grow(moves ? f->share_at(f->now_.since + f->ahead_) : 1.0);
  }
  for (FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp)) f->laws_changed();
}

// Returns true if a stage that lasts a number of ball passes has ended at the time `since` after it
// began.
bool FixBearingHeat::passed(double since, double passes) const
{
  return since >= passes * now_.pass * (1.0 - 1e-9) - 0.5 * update->dt;
}

// Returns the fraction of the change of the clearance that has been made at the time `since` after
// a ramp began. It is 1 at the last step of the ramp, even if a ball pass is not a whole number of
// steps.
double FixBearingHeat::share_at(double since) const
{
  return passed(since) ? 1.0 : since / now_.pass;
}

// Sets the clearance to an intermediate value, at the fraction `share` of the way from its previous
// value to its value at the current temperatures.
void FixBearingHeat::grow(double share)
{
  double strain[parts];
  for (int k = 0; k < parts; ++k)
    strain[k] =
        steel_expansion * (now_.from[k] + share * (now_.to[k] - now_.from[k]) - network_.ambient);
  strain[1] *= ball_.expansion;
  pair_->coefficients().grow(bearing_->balls, strain[0], strain[1], strain[2]);
}

bool FixBearingHeat::covers_type(int ball_type) const
{
  return bearing_ && bearing_->balls == ball_type;
}

std::array<double, 5> FixBearingHeat::temperatures() const
{
  const double *t = now_.heat.law;
  return {t[0], t[1], t[2], t[3], now_.oil};
}

double FixBearingHeat::value(int column) const
{
  const HeatState &h = now_.heat;
  switch (column) {
    case of::TIME: return h.time;
    case of::INNER: return h.at[0];
    case of::BALLS: return h.at[1];
    case of::OUTER: return h.at[2];
    case of::HOUSING: return h.at[3];
    case of::OIL: return HeatState::oil_of(h.at);
    case of::POWER: return h.start.power();
    case of::HEAT_INNER: return h.start.heat[0];
    case of::HEAT_BALLS: return h.start.heat[1];
    case of::HEAT_OUTER: return h.start.heat[2];
    case of::HEAT_OIL: return h.start.heat[heat_nodes];
    case of::OUTLET: return outlet();
    case of::CONTACTS_INNER: return h.start.inner;
    case of::CONTACTS_OUTER: return h.start.outer;
    case of::BOOKED: return h.booked;
    case of::CARRIED: return h.carried;
    case of::STORED: return stored_heat(network_, now_.begin, h.at);
    case of::CLEARANCE: return clearance();
    case of::GAIN: return h.gain;
    case of::JUMP: return now_.jump;
    case of::CORRECTION: return h.correction;
    case of::RUN: return now_.run;
  }
  return 0.0;
}

// Returns the temperature (C) of the oil at the outlet or, if no oil flows, of the oil in the
// contacts.
double FixBearingHeat::outlet() const
{
  const HeatState &h = now_.heat;
  if (!network_.oil.flows() || h.seen == 0.0) return HeatState::oil_of(h.at);
  OilFlow oil = network_.oil;
  oil.convection = h.start.convection;
  return oil.outlet(h.at, h.start.heat[heat_nodes]);
}

// Returns the diametral clearance (m) of the parts at their current temperatures.
double FixBearingHeat::clearance() const
{
  const double *t = now_.heat.at, cold = network_.ambient;
  return bearing_->number("clearance") +
         clearance_change(bearing_->number("b_inner_raceway"), bearing_->number("b_outer_raceway"),
                          0.5 * bearing_->number("ball_diameter"), t[0] - cold, t[1] - cold,
                          t[2] - cold, ball_);
}

double FixBearingHeat::compute_scalar() { return compute_vector(of::OIL); }

double FixBearingHeat::compute_vector(int k) { return idle_ || !bearing_ ? 0.0 : value(k); }

void FixBearingHeat::write_row(const Row &row)
{
  FILE *f = file_.file();
  if (!f) return;
  for (int k = 0; k < of::N; ++k) fprintf(f, k ? " %.12g" : "%.12g", row[k]);
  fputc('\n', f);
  fflush(f);
}

void FixBearingHeat::write_restart(FILE *fp)
{
  now_.passes = static_cast<double>(passes_.size());
  bearing::NumberWriter list;
  list(now_, rows_, passes_);
  if (comm->me == 0) list.write(fp);
}

void FixBearingHeat::restart(char *buf)
{
  bearing::NumberReader list(buf);
  list(now_);
  rows_.resize(static_cast<size_t>(now_.rows));
  passes_.resize(static_cast<size_t>(now_.passes));
  list(rows_, passes_);
  rewrite_ = true;
}
