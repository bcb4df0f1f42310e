// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_ring.h"

#include "../core/figures/fix_columns.h"
#include "../core/numbers/number_list.h"
#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "named_bearing.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::DrivenValue;
using raceway::Freedom;
using raceway::RingProgram;
using raceway::RingValue;
using raceway::Vec3;

FixBearingRing::FixBearingRing(LAMMPS *lmp, int narg, char **arg) :
    FixBearingRing(lmp, narg, arg, Words::unread)
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  bearing::RingWords words(args, axes_, settings_, true);
  while (args.more())
    if (!words.take()) args.unknown();
  words.finish(usual_body());
  settings_are_read();
}

FixBearingRing::FixBearingRing(LAMMPS *lmp, int narg, char **arg, Words) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, std::string("fix ") + style))
{
  time_integrate = 1;
  restart_global = 1;
  vector_flag = array_flag = 1;
  size_vector = size_array_cols = bearing::of_fix_ring::N;
  extvector = extarray = 0;
  global_freq = 1;
  axes_.along = pair_->coefficients().axis_index();
}

// Returns the usual mass and inertia of the inner ring of a named bearing; for other rings they are
// unknown.
bearing::RingBody FixBearingRing::usual_body() const
{
  std::vector<int> types;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) types.push_back(atom->type[i]);
  types = bearing::gather_all(types, world);
  bearing::RingBody body;
  for (const int type : types) {
    const bearing::NamedBearing *b = bearing::bearing_of_type(lmp, type);
    if (!b || b->inner != type) return {};
    const auto of = [b](const char *name) { return b->number(name); };
    const bearing::RingBody one = {of("inner_mass"), {of("inner_inertia"), of("inner_inertia_t")}};
    if (type != types.front() && one.mass != body.mass) return {};
    body = one;
  }
  return body;
}

void FixBearingRing::settings_are_read()
{
  find_rings();
  // a variable may be atom-style, in which case its values travel with the rings
  called_back_ = std::any_of(settings_.value, settings_.value + RingProgram::N_VALUE,
                             [](const DrivenValue &v) { return v.is_variable(); });
  if (called_back_) {
    BRG_SET_MAXEXCHANGE(RingProgram::N_VALUE);
    atom->add_callback(0);
  }
}

// Finds the rings anew in every run, because the group may change between two runs.
void FixBearingRing::find_rings()
{
  const std::string group_name = group->names[igroup];
  std::vector<bearing::tag_t> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      if (!pair_->coefficients().is_ring(atom->type[i]))
        BRG_ONE(bearing::name_of(*this) + ": atom " + std::to_string(atom->tag[i]) + " of group " +
                group_name + " is of type " + std::to_string(atom->type[i]) +
                ", which no pair_coeff names as a ring");
      mine.push_back(atom->tag[i]);
    }
  tags_ = bearing::gather_all(mine, world);
  std::sort(tags_.begin(), tags_.end());
  if (tags_.empty())
    BRG_ALL(bearing::name_of(*this) + ": missing ring, group " + group_name + " is empty");
  size_array_rows = static_cast<int>(tags_.size());
}

bool FixBearingRing::constant() const
{
  const RingProgram &p = settings_.program;
  return !called_back_ && p.turning.size == 0.0 && p.unbalance.moment == 0.0 &&
         std::none_of(p.mode, p.mode + RingProgram::SPIN,
                      [](Freedom f) { return f == Freedom::speed; }) &&
         p.mode[RingProgram::SPIN] != Freedom::position;
}

std::vector<double> FixBearingRing::imposed_spin()
{
  constexpr int spin = RingProgram::SPIN;
  std::vector<double> of(atom->nlocal, NAN);
  DrivenValue &value = settings_.value[spin];
  if (settings_.program.mode[spin] == Freedom::free) return of;
  const bool turns = settings_.program.mode[spin] == Freedom::speed;
  value.check(lmp, bearing::name_of(*this));
  const double all = turns ? value.now(lmp) : 0.0;
  const std::vector<double> own =
      turns && value.by_atom() ? value.of_atoms(lmp, igroup) : std::vector<double>();
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) of[i] = own.empty() ? all : own[i];
  return of;
}

double FixBearingRing::constant_spin() const
{
  switch (settings_.program.mode[RingProgram::SPIN]) {
    case Freedom::fixed: return 0.0;
    case Freedom::speed: return settings_.value[RingProgram::SPIN].constant_value();
    default: return NAN;
  }
}

// Stops with an error if another fix moves a ring of the group.
void FixBearingRing::refuse_another_mover()
{
  for (FixBearingRing *other : bearing::fixes_of<FixBearingRing>(lmp)) {
    if (other == this) break;    // only the later of two such fixes reports the error
    for (int i = 0; i < atom->nlocal; ++i)
      if (moves(i) && other->moves(i))
        BRG_ONE(bearing::name_of(*this) + " and " + bearing::name_of(*other) +
                " both move ring atom " + std::to_string(atom->tag[i]));
  }
}

FixBearingRing::~FixBearingRing()
{
  if (called_back_) atom->delete_callback(id, 0);
}

int FixBearingRing::setmask() { return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE; }

void FixBearingRing::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/ring");
  state_ = pair_->state();
  if (tilts()) state_->follow_axes();
  find_rings();
  refuse_another_mover();
  own_.clear();
  for (int k = 0; k < RingProgram::N_VALUE; ++k) {
    settings_.value[k].check(lmp, bearing::name_of(*this));
    if (settings_.value[k].by_atom()) own_.push_back(k);
  }
  grow_arrays(atom->nmax);    // atoms are sorted and exchanged before the values are set
  int by_another = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i) && pair_->is_implicit(i)) by_another = 1;
  MPI_Allreduce(MPI_IN_PLACE, &by_another, 1, MPI_INT, MPI_MAX,
                world);    // ranks without rings also need the result
  by_another_ = by_another;
  time_integrate = by_another_ ? 0 : 1;
  find_holder();
  if (mass_of_atom() > 0.0)
    for (int i = 0; i < atom->nlocal; ++i)
      if (moves(i)) atom->rmass[i] = mass_of_atom();    // for the kinetic energy in thermo output
}

// Finds the ring at the other end of the supports. That ring is moved by another fix, whose final
// half step must come after the forces of these supports have been added.
void FixBearingRing::find_holder()
{
  between_.clear();
  holder_ = 0;
  holder_moves_by_ = nullptr;
  if (settings_.holder.empty()) return;
  const std::string me = bearing::name_of(*this);
  const int which = group->find(settings_.holder.c_str());
  if (which < 0) BRG_ALL(me + ": there is no group '" + settings_.holder + "' to hold its ring");
  std::vector<bearing::tag_t> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & group->bitmask[which]) mine.push_back(atom->tag[i]);
  const std::vector<bearing::tag_t> all = bearing::gather_all(mine, world);
  if (all.size() != 1)
    BRG_ALL(me + ": group '" + settings_.holder + "' that holds its ring has " +
            std::to_string(all.size()) + " atoms, must have one ring");
  for (FixBearingRing *f : bearing::fixes_of<FixBearingRing>(lmp))
    if (std::binary_search(f->tags_.begin(), f->tags_.end(), all.front())) holder_moves_by_ = f;
  const std::string ring = "ring " + std::to_string(all.front());
  if (!holder_moves_by_ || holder_moves_by_ == this)
    BRG_ALL(me + ": " + ring + ", which holds its ring, needs a fix bearing/ring of its own");
  if (holder_moves_by_->shaft() != 0)
    BRG_ALL(me + ": " + ring + ", which holds its ring, is on a shaft, but must move alone");
  if (!holder_moves_by_->settings_.holder.empty())
    BRG_ALL(me + ": " + ring + ", which holds its ring, must itself be held to the ground");
  bearing::require_order(lmp, *this, *holder_moves_by_,
                         "its last half step must follow the forces of the supports");
  holder_ = all.front();
}

// Driven speeds apply from the first instant on. In the set-up, the load is added to the forces in
// the same way as in any step.
void FixBearingRing::setup(int vflag)
{
  if (holder_moves_by_ && holder_moves_by_->by_another_ != by_another_)
    BRG_ALL(bearing::name_of(*this) + " and " + bearing::name_of(*holder_moves_by_) +
            ", whose ring holds its ring, need the same integrator");
  find_own_values();
  evaluate(0, RingProgram::N_VALUE);
  warn_of_idle_loads();
  before_ = now_;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      const Values target = values(i);
      for (int k = 0; k < 3; ++k)
        if (settings_.program.mode[k] == Freedom::speed)
          atom->v[i][axes_.lab_axis(k)] = target.of[k];
      if (settings_.program.mode[RingProgram::SPIN] == Freedom::speed) {
        const Vec3 e = state_->axis(i), w = Vec3::from(atom->omega[i]);
        const double missing = target.of[RingProgram::SPIN] - dot(w, e);
        // rounding errors are not corrected, so that a continued run is bitwise identical to an
        // uninterrupted one
        if (std::fabs(missing) > 1e-12 * norm(w)) (w + e * missing).to(atom->omega[i]);
      }
    }
  post_force(vflag);
  hold(0.0);
  noted_ = false;    // the forces of later fixes have not been added yet
}

// Evaluates the values that are given as numbers or equal-style variables.
void FixBearingRing::evaluate(int first, int last)
{
  for (int k = first; k < last; ++k) {
    now_.of[k] = settings_.value[k].now(lmp);
    if (k >= RingProgram::FORCE && now_.of[k] != 0.0)
      warn_if_idle(k - RingProgram::FORCE, now_.of[k]);
  }
}

// Evaluates atom-style variables only once per run, because evaluating them for every atom in every
// step would take longer than computing the bearings.
void FixBearingRing::find_own_values()
{
  for (int k : own_) {
    const std::vector<double> all = settings_.value[k].of_atoms(lmp, igroup);
    for (int i = 0; i < atom->nlocal; ++i) {
      if (!moves(i)) continue;
      if (!std::isfinite(all[i]))
        BRG_ONE(bearing::name_of(*this) + ": variable '" + settings_.value[k].name() + "' is " +
                bearing::text(all[i]) + " for ring atom " + std::to_string(atom->tag[i]));
      per_ring_[i].of[k] = all[i];
    }
  }
}

FixBearingRing::Values FixBearingRing::values(int i) const
{
  Values v = now_;
  for (int k : own_) v.of[k] = per_ring_[i].of[k];
  return v;
}

std::vector<RingValue> FixBearingRing::own_values(int i) const
{
  std::vector<RingValue> list;
  for (int k : own_) list.push_back({k, per_ring_[i].of[k]});
  return list;
}

void FixBearingRing::grow_arrays(int n)
{
  if (!own_.empty()) per_ring_.resize(n);
}

void FixBearingRing::copy_arrays(int i, int j, int)
{
  if (!own_.empty()) per_ring_[j] = per_ring_[i];
}

int FixBearingRing::pack_exchange(int i, double *buf)
{
  int m = 0;
  for (int k : own_) buf[m++] = per_ring_[i].of[k];
  return m;
}

int FixBearingRing::unpack_exchange(int i, double *buf)
{
  int m = 0;
  for (int k : own_) per_ring_[i].of[k] = buf[m++];
  return m;
}

double FixBearingRing::memory_usage()
{
  return per_ring_.capacity() * sizeof(Values) + tags_.capacity() * sizeof(bearing::tag_t) +
         report_.capacity() * sizeof(double);
}

RingProgram FixBearingRing::program(const std::vector<RingValue> &own) const
{
  Values of[2] = {before_, now_};
  for (const RingValue &v : own) of[0].of[v.which] = of[1].of[v.which] = v.value;
  RingProgram p = settings_.program;
  p.end = time_;
  p.length = update->dt;
  for (int end = 0; end < 2; ++end) {
    p.set_values(end, of[end].of);
    p.leverage[end] = of[end].leverage;
  }
  p.spin_growth = (of[1].of[RingProgram::SPIN] - of[0].of[RingProgram::SPIN]) / p.length;
  return p;
}

// Returns the RingProgram for velocity Verlet, in which it is needed only at the end of a step.
RingProgram FixBearingRing::at_end(const Values &of) const
{
  RingProgram p = settings_.program;
  p.end = time_;
  for (int end = 0; end < 2; ++end) {
    p.set_values(end, of.of);
    p.leverage[end] = of.leverage;
  }
  p.spin_growth = (now_.of[RingProgram::SPIN] - before_.of[RingProgram::SPIN]) / update->dt;
  return p;
}

void FixBearingRing::begin_step()
{
  note_setup();
  time_ += update->dt;
  reported_ = -1;
  between_.clear();
  before_ = now_;
  evaluate(0, RingProgram::N_VALUE);
  check_jumps();
}

// Stops with an error if an imposed position or spin speed jumped in the last step. A jump is a
// change that is far larger than those in the previous and the following step, and too large for
// contacts to follow (more than 1 um, or a slip of 1 %).
void FixBearingRing::check_jumps()
{
  constexpr double far = 20.0;
  constexpr int spin = RingProgram::SPIN;
  for (int k = 0; k < RingProgram::N_DOF; ++k) {
    double &at = imposed_.at[k], &last = imposed_.moved[k], &before = imposed_.before[k];
    const Freedom imposed = k == spin ? Freedom::speed : Freedom::position;
    const double here = settings_.program.mode[k] == imposed ? now_.of[k] : NAN;
    const double moved = std::isnan(at) || std::isnan(here) ? 0.0 : std::fabs(here - at);
    const bool tilt = k >= RingProgram::TILT && k != spin;
    const double small = k == spin ? std::fmax(1e-3, 0.01 * std::fabs(at)) : tilt ? 5e-5 : 1e-6;
    if (last > std::fmax(small, far * std::fmax(before, moved))) {
      const char axis[] = {"xyz"[axes_.lab_axis(tilt ? k - RingProgram::TILT : k % 3)], '\0'};
      const std::string what =
          k == spin ? "spin speed" : std::string("position along ") + (tilt ? "r" : "") + axis;
      BRG_ALL(bearing::name_of(*this) + ": the " + what + " jumps by " + bearing::text(last) +
              (k == spin ? " rad/s"
               : tilt    ? " rad"
                         : " m") +
              " in step " + std::to_string(update->ntimestep - 1) + ", with " +
              bearing::text(before) + " and " + bearing::text(moved) +
              " in the steps before and after: the motion of a ring needs a continuous formula");
    }
    before = last;
    last = moved;
    at = here;
  }
}

void FixBearingRing::write_restart(FILE *fp)
{
  bearing::NumberWriter list;
  list(time_, imposed_);
  if (comm->me == 0) list.write(fp);
}

void FixBearingRing::restart(char *buf) { bearing::NumberReader{buf}(time_, imposed_); }
