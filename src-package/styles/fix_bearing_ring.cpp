// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_ring.h"

#include "../contacts/fix_columns.h"
#include "../contacts/ring_motion.h"
#include "../deck/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::DrivenValue;
using raceway::Freedom;
using raceway::RingAtom;
using raceway::RingProgram;
using raceway::RingValue;
using raceway::Support;
using raceway::Vec3;

FixBearingRing::FixBearingRing(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/ring"))
{
  time_integrate = 1;
  restart_global = 1;
  vector_flag = array_flag = 1;
  size_vector = size_array_cols = bearing::of_fix_ring::N;
  extvector = extarray = 0;
  global_freq = 1;
  axes_.along = pair_->axis_index();
  parse(narg, arg);
  find_rings();
  // a variable may be atom-style: values of their own travel with the rings
  called_back_ = std::any_of(value_, value_ + RingProgram::N_VALUE,
                             [](const DrivenValue &v) { return v.is_variable(); });
  if (called_back_) {
    BRG_SET_MAXEXCHANGE(RingProgram::N_VALUE);
    atom->add_callback(0);
  }
}

// The group may change between two runs: every run looks anew.
void FixBearingRing::find_rings()
{
  const std::string group_name = group->names[igroup];
  std::vector<bearing::tag_t> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      if (!pair_->is_ring_type(atom->type[i]))
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

// Each ring has one fix that says how it moves.
void FixBearingRing::refuse_another_mover()
{
  for (FixBearingRing *other : bearing::fixes_of<FixBearingRing>(lmp)) {
    if (other == this) break;    // the later of two fixes tells
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

void FixBearingRing::read_freedom(Arguments &args, const std::string &name, int dof)
{
  // as Freedom counts them
  program_.mode[dof] =
      static_cast<Freedom>(args.choice(name, {"fixed", "free", "speed", "position"}));
  if (program_.mode[dof] == Freedom::speed || program_.mode[dof] == Freedom::position)
    value_[dof] = DrivenValue::read(args, name, true);
}

static const char *const lab[] = {"x", "y", "z"}, *const turn[] = {"rx", "ry", "rz"};

// A displacement or a tilt by its name.
int FixBearingRing::read_direction(Arguments &args) const
{
  std::vector<std::string> names(RingProgram::SPIN);
  for (int k = 0; k < 3; ++k) names[k] = lab[axes_.lab_axis(k)];
  for (int k = 0; k < 2; ++k) names[RingProgram::TILT + k] = turn[axes_.lab_axis(k)];
  return args.choice("support", names);
}

void FixBearingRing::parse(int narg, char **arg)
{
  Arguments args(lmp, std::string("fix ") + id + " bearing/ring", narg, arg, 3);
  const int across[] = {axes_.lab_axis(0), axes_.lab_axis(1)};
  int number[3];    // of a lab axis, with the bearing axis third
  for (int k = 0; k < 3; ++k) number[axes_.lab_axis(k)] = k;
  raceway::RingInertia &inertia = program_.inertia;
  while (args.more()) {
    bool known = false;
    for (int k = 0; k < 3 && !known; ++k)
      if (args.take(lab[k])) {
        read_freedom(args, lab[k], number[k]);
        known = true;
      }
    for (int k = 0; k < 2 && !known; ++k)
      if (args.take(turn[across[k]])) {
        read_freedom(args, turn[across[k]], RingProgram::TILT + k);
        known = true;
      }
    if (known) continue;
    if (args.take("spin")) {
      read_freedom(args, "spin", RingProgram::SPIN);
      if (program_.mode[RingProgram::SPIN] == Freedom::position)
        args.fail("spin takes fixed, free or speed, not position");
    } else if (args.take("mass")) {
      program_.mass = args.positive("mass (kg)");
    } else if (args.take("inertia")) {
      inertia.axial = args.positive("inertia about the axis (kg m^2)");
      inertia.transverse = args.positive("inertia across the axis (kg m^2)");
      if (inertia.axial > 2.0 * inertia.transverse)
        args.fail("inertia " + bearing::text(inertia.axial) + " " +
                  bearing::text(inertia.transverse) +
                  ": no body has more than twice as much about its axis as across it");
    } else if (args.take("force")) {
      for (int k = 0; k < 3; ++k)
        value_[RingProgram::FORCE + number[k]] = DrivenValue::read(args, "force (N)", true);
    } else if (args.take("moment")) {
      for (int k = 0; k < 3; ++k)
        value_[RingProgram::MOMENT + number[k]] = DrivenValue::read(args, "moment (N m)", true);
    } else if (args.take("rotating")) {
      program_.turning.size = args.number("rotating force (N)");
      program_.turning.speed = args.number("speed of the rotating force (rad/s)");
      program_.turning.phase = args.number("phase of the rotating force (rad)");
    } else if (args.take("unbalance")) {
      program_.unbalance.moment = args.non_negative("unbalance (kg m)");
      program_.unbalance.phase = args.number("phase of the unbalance (rad)");
    } else if (args.take("support")) {
      const int dof = read_direction(args);
      Support &on = program_.support[dof];
      on.stiffness = args.within("stiffness of the support", 0.0, 1e15);
      on.damping = args.within("damping of the support", 0.0, 1e12);
      if (on.stiffness == 0.0 && on.damping == 0.0)
        args.fail("a support with neither stiffness nor damping");
      program_.supported = true;
    } else if (args.take("ramp")) {
      program_.ramp = args.non_negative("ramp time (s)");
    } else {
      args.unknown(std::string("x, y, z, ") + turn[across[0]] + ", " + turn[across[1]] +
                   ", spin, mass, inertia, force, moment, rotating, unbalance, support, ramp");
    }
  }
  if (program_.unbalance.moment > 0.0 && program_.mode[RingProgram::SPIN] != Freedom::speed)
    args.fail("unbalance needs 'spin speed W': the mass off centre turns with an imposed spin");
  for (int k = 0; k < RingProgram::SPIN; ++k)
    if ((program_.support[k].stiffness > 0.0 || program_.support[k].damping > 0.0) &&
        !program_.free(k)) {
      const std::string name = k < 3 ? lab[axes_.lab_axis(k)] : turn[axes_.lab_axis(k - 3)];
      args.fail("'support " + name + "' needs '" + name + " free'");
    }
  for (int k = 0; k < 3; ++k)
    if (program_.free(number[k]) && program_.mass == 0.0)
      args.fail(std::string(lab[k]) + " free needs 'mass M'");
  for (int k = RingProgram::TILT; k < RingProgram::N_DOF; ++k)
    if (program_.free(k) && inertia.axial == 0.0)
      args.fail("a free tilt or spin needs 'inertia AXIAL TRANSVERSE'");
}

int FixBearingRing::setmask() { return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE; }

void FixBearingRing::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/ring");
  state_ = pair_->state();
  find_rings();
  refuse_another_mover();
  own_.clear();
  for (int k = 0; k < RingProgram::N_VALUE; ++k) {
    value_[k].check(lmp, bearing::name_of(*this));
    if (value_[k].by_atom()) own_.push_back(k);
  }
  grow_arrays(atom->nmax);    // atoms are sorted and exchanged before the values are known
  int by_another = 0;
  for (const FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp))
    for (int i = 0; i < atom->nlocal; ++i)
      if (moves(i) && (atom->mask[i] & f->groupbit)) by_another = 1;
  MPI_Allreduce(MPI_IN_PLACE, &by_another, 1, MPI_INT, MPI_MAX,
                world);    // who owns no ring must know
  by_another_ = by_another;
  time_integrate = by_another_ ? 0 : 1;
  if (program_.mass > 0.0)
    for (int i = 0; i < atom->nlocal; ++i)
      if (moves(i)) atom->rmass[i] = program_.mass;    // kinetic energy in thermo output
}

// Driven speeds hold from the first instant; forces of the set-up get the load like any others.
void FixBearingRing::setup(int vflag)
{
  find_own_values();
  evaluate(0, RingProgram::N_VALUE);
  before_ = now_;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      const Values target = values(i);
      for (int k = 0; k < 3; ++k)
        if (program_.mode[k] == Freedom::speed) atom->v[i][axes_.lab_axis(k)] = target.of[k];
      if (program_.mode[RingProgram::SPIN] == Freedom::speed) {
        const Vec3 e = state_->axis(i), w = Vec3::from(atom->omega[i]);
        const double missing = target.of[RingProgram::SPIN] - dot(w, e);
        // rounding of a run that goes on is left alone: its bits are those of the unbroken run
        if (std::fabs(missing) > 1e-14 * norm(w)) (w + e * missing).to(atom->omega[i]);
      }
    }
  post_force(vflag);
  hold(0.0);
  note_accelerations();
}

// Numbers and equal-style variables.
void FixBearingRing::evaluate(int first, int last)
{
  for (int k = first; k < last; ++k) now_.of[k] = value_[k].now(lmp);
}

// Atom-style variables hold for a run: evaluating them for every atom in every step would cost more
// than the bearings.
void FixBearingRing::find_own_values()
{
  for (int k : own_) {
    const std::vector<double> all = value_[k].of_atoms(lmp, igroup);
    for (int i = 0; i < atom->nlocal; ++i) {
      if (!moves(i)) continue;
      if (!std::isfinite(all[i]))
        BRG_ONE(std::string("fix ") + id + " bearing/ring: variable '" + value_[k].name() +
                "' is " + bearing::text(all[i]) + " for ring atom " + std::to_string(atom->tag[i]));
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
  RingProgram p = program_;
  p.end = time_;
  p.length = update->dt;
  for (int end = 0; end < 2; ++end) p.set_values(end, of[end].of);
  p.spin_growth = (of[1].of[RingProgram::SPIN] - of[0].of[RingProgram::SPIN]) / p.length;
  return p;
}

// Velocity Verlet asks for the end of its step only.
RingProgram FixBearingRing::at_end(int i) const
{
  RingProgram p = program_;
  p.end = time_;
  const Values of = values(i);
  for (int end = 0; end < 2; ++end) p.set_values(end, of.of);
  p.spin_growth = (now_.of[RingProgram::SPIN] - before_.of[RingProgram::SPIN]) / update->dt;
  return p;
}

RingAtom FixBearingRing::read(int i) const
{
  RingAtom r;
  read_place(*atom, i, state_->ring(i), axes_, r);
  r.w = axes_.third(Vec3::from(atom->omega[i]));
  return r;
}

void FixBearingRing::write(int i, const RingAtom &r)
{
  write_place(r, axes_, *atom, i, state_->ring(i));
  axes_.lab(r.w).to(atom->omega[i]);
}

void FixBearingRing::begin_step()
{
  time_ += update->dt;
  reported_ = -1;
  before_ = now_;
  evaluate(0, RingProgram::N_VALUE);
}

// Half a step of velocity from the forces.
void FixBearingRing::kick()
{
  const double half = 0.5 * update->dt * force->ftm2v;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i))
      write(i, kicked(program_, read(i), axes_.third(Vec3::from(atom->f[i])),
                      axes_.third(Vec3::from(atom->torque[i])), half));
}

void FixBearingRing::initial_integrate(int)
{
  if (by_another_) return;
  time_ += update->dt;
  reported_ = -1;
  kick();
  before_ = now_;
  evaluate(0, RingProgram::N_DOF);
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) write(i, coasted(at_end(i), read(i), update->dt));
}

void FixBearingRing::post_force(int)
{
  evaluate(RingProgram::FORCE, RingProgram::N_VALUE);
  // from the sums of the rings: other fixes may have added to the forces of the atoms already
  const bearing::RingSum &sums = pair_->ring_sum();
  contacts_.clear();
  for (int n = 0; n < sums.rings(); ++n)
    if (moves(sums.ring(n)))
      contacts_.push_back({atom->tag[sums.ring(n)], sums.force(n), sums.torque(n)});
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      const RingProgram p = at_end(i);
      axes_.lab(load_of(p, i)).add_to(atom->f[i]);
      axes_.lab(p.moment_at(1.0)).add_to(atom->torque[i]);
    }
}

// The supports' share of force and moment, when all other forces are there. Velocities are `half`
// seconds behind.
void FixBearingRing::hold(double half)
{
  if (!program_.supported) return;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) hold(i, program_, half);
}

void FixBearingRing::hold(int i, const RingProgram &p, double half)
{
  const RingAtom r = read(i);
  const Vec3 d = r.x - r.origin, push = axes_.third(Vec3::from(atom->f[i])),
             moment = axes_.third(Vec3::from(atom->torque[i])), across = r.w - r.e * dot(r.w, r.e);
  const double moved[] = {d.x, d.y, d.z, r.tilt[0], r.tilt[1]},
               rate[] = {r.v.x, r.v.y, r.v.z, across.x, across.y},
               other[] = {push.x, push.y, push.z, moment.x, moment.y};
  double on[RingProgram::SPIN] = {};
  for (int k = 0; k < RingProgram::SPIN; ++k)
    if (p.free(k))
      on[k] = verlet_support(p.support[k], moved[k], rate[k], other[k], p.inertia_of(k), half);
  axes_.lab(Vec3{on[0], on[1], on[2]}).add_to(atom->f[i]);
  axes_.lab(Vec3{on[3], on[4], 0.0}).add_to(atom->torque[i]);
}

Vec3 FixBearingRing::load_of(const RingProgram &p, int i) const
{
  return p.force_at(1.0, state_->ring(i).angle);
}

void FixBearingRing::note_accelerations()
{
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i))
      state_->ring(i).acceleration =
          axes_.lab(program_.acceleration(axes_.third(Vec3::from(atom->f[i]))));
}

void FixBearingRing::final_integrate()
{
  hold(by_another_ ? 0.0 : 0.5 * update->dt * force->ftm2v);
  if (!by_another_) kick();
  note_accelerations();
  reported_ = -1;    // a variable may have asked in the middle of the step
}

// Rings live on one rank each: a sum over ranks only moves their numbers.
void FixBearingRing::gather_reports()
{
  if (reported_ == update->ntimestep) return;
  reported_ = update->ntimestep;
  report_.assign(tags_.size() * size_vector, 0.0);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    const auto known = std::lower_bound(tags_.begin(), tags_.end(), atom->tag[i]);
    if (known == tags_.end() || *known != atom->tag[i])
      continue;    // in the group since the last run: the next run knows it
    using namespace bearing::of_fix_ring;
    double *r = &report_[(known - tags_.begin()) * size_vector];
    const bearing::RingMotion &ring = state_->ring(i);
    const Vec3 w = Vec3::from(atom->omega[i]);
    (Vec3::from(atom->x[i]) - ring.origin).to(r + X);
    Vec3::from(atom->v[i]).to(r + VX);
    raceway::tilt_of(axes_.third(ring.axis), r + TILT1);
    r[SPIN] = dot(w, ring.axis);
    r[ANGLE] = ring.angle;
    const RingProgram p = at_end(i);
    axes_.lab(load_of(p, i)).to(r + LOAD_X);
    if (p.supported) axes_.lab(p.support_force(read(i))).to(r + SUPPORT_X);
    ring.acceleration.to(r + AX);
    const auto contact =
        std::lower_bound(contacts_.begin(), contacts_.end(), atom->tag[i],
                         [](const ContactLoad &c, bearing::tag_t tag) { return c.ring < tag; });
    if (contact == contacts_.end() || contact->ring != atom->tag[i]) continue;    // none yet
    contact->force.to(r + FX);
    contact->moment.to(r + MX);
    r[TORQUE] = dot(contact->moment, ring.axis);
  }
  MPI_Allreduce(MPI_IN_PLACE, report_.data(), static_cast<int>(report_.size()), MPI_DOUBLE, MPI_SUM,
                world);
}

double FixBearingRing::compute_vector(int k) { return compute_array(0, k); }

double FixBearingRing::compute_array(int row, int k)
{
  // before the first run, or after the pair style was replaced, there is nothing to tell
  if (!state_ || modify->find_fix(FixBearingState::fixed_id) < 0) return 0.0;
  gather_reports();
  // rows of rings that joined the group come with the next run
  return static_cast<size_t>(row) < tags_.size() ? report_[row * size_vector + k] : 0.0;
}

std::vector<bearing::ColumnList::Item> FixBearingRing::columns() const
{
  // its motion and what it meets; the load is what the deck gave
  std::vector<Item> list;
  for (int k = 0; k < bearing::of_fix_ring::LOAD_X; ++k)
    list.push_back({bearing::of_fix_ring::list[k].name, bearing::of_fix_ring::list[k].format});
  return list;
}

void FixBearingRing::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const int size = sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&time_, sizeof(double), 1, fp);
}

void FixBearingRing::restart(char *buf) { memcpy(&time_, buf, sizeof(double)); }
