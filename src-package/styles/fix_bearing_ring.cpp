// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_ring.h"

#include "../deck/arguments.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::DrivenValue;
using raceway::Vec3;

static Vec3 unit(int k) { return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0}; }

FixBearingRing::FixBearingRing(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/ring"))
{
  time_integrate = 1;
  restart_global = 1;
  vector_flag = array_flag = 1;
  size_vector = size_array_cols = N_REPORT;
  extvector = extarray = 0;
  global_freq = 1;
  along_ = pair_->axis_index();
  across_[0] = (along_ + 1) % 3;
  across_[1] = (along_ + 2) % 3;
  parse(narg, arg);

  std::vector<int> mine;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) {
      if (!pair_->is_ring_type(atom->type[i]))
        BRG_ONE(std::string("fix ") + id + " bearing/ring: atom " + std::to_string(atom->tag[i]) +
                " of group " + arg[1] + " is of type " + std::to_string(atom->type[i]) +
                ", which no pair_coeff names as a ring");
      mine.push_back(static_cast<int>(atom->tag[i]));
    }
  std::vector<int> count(comm->nprocs), offset(comm->nprocs, 0);
  int n = static_cast<int>(mine.size());
  MPI_Allgather(&n, 1, MPI_INT, count.data(), 1, MPI_INT, world);
  for (int p = 1; p < comm->nprocs; ++p) offset[p] = offset[p - 1] + count[p - 1];
  tags_.resize(offset.back() + count.back());
  MPI_Allgatherv(mine.data(), n, MPI_INT, tags_.data(), count.data(), offset.data(), MPI_INT,
                 world);
  std::sort(tags_.begin(), tags_.end());
  if (tags_.empty())
    BRG_ALL(std::string("fix ") + id + " bearing/ring: missing ring, group " + arg[1] +
            " is empty");
  size_array_rows = static_cast<int>(tags_.size());
  // a variable may be atom-style: values of their own travel with the rings
  called_back_ =
      std::any_of(value_, value_ + N_VALUE, [](const DrivenValue &v) { return v.is_variable(); });
  if (called_back_) {
    BRG_SET_MAXEXCHANGE(N_VALUE);
    atom->add_callback(0);
  }
}

FixBearingRing::~FixBearingRing()
{
  if (called_back_) atom->delete_callback(id, 0);
}

void FixBearingRing::read_freedom(Arguments &args, const std::string &name, int dof)
{
  mode_[dof] = args.choice(name, {"fixed", "free", "speed", "position"});
  if (mode_[dof] >= speed) value_[dof] = DrivenValue::read(args, name, true);
}

void FixBearingRing::parse(int narg, char **arg)
{
  Arguments args(lmp, std::string("fix ") + id + " bearing/ring", narg, arg, 3);
  static const char *lab[] = {"x", "y", "z"}, *turn[] = {"rx", "ry", "rz"};
  while (args.more()) {
    bool known = false;
    for (int k = 0; k < 3 && !known; ++k)
      if (args.take(lab[k])) {
        read_freedom(args, lab[k], k);
        known = true;
      }
    for (int k = 0; k < 2 && !known; ++k)
      if (args.take(turn[across_[k]])) {
        read_freedom(args, turn[across_[k]], 3 + k);
        known = true;
      }
    if (known) continue;
    if (args.take("spin")) {
      read_freedom(args, "spin", SPIN_DOF);
      if (mode_[SPIN_DOF] == position) args.fail("spin takes fixed, free or speed, not position");
    } else if (args.take("mass")) {
      mass_ = args.positive("mass (kg)");
    } else if (args.take("inertia")) {
      inertia_.axial = args.positive("inertia about the axis (kg m^2)");
      inertia_.transverse = args.positive("inertia across the axis (kg m^2)");
      if (inertia_.axial > 2.0 * inertia_.transverse)
        args.fail("inertia " + bearing::text(inertia_.axial) + " " +
                  bearing::text(inertia_.transverse) +
                  ": no body has more than twice as much about its axis as across it");
    } else if (args.take("force")) {
      for (int k = 0; k < 3; ++k) value_[FORCE + k] = DrivenValue::read(args, "force (N)", true);
    } else if (args.take("moment")) {
      for (int k = 0; k < 3; ++k)
        value_[MOMENT + k] = DrivenValue::read(args, "moment (N m)", true);
    } else if (args.take("ramp")) {
      ramp_time_ = args.non_negative("ramp time (s)");
    } else {
      args.unknown(std::string("x, y, z, ") + turn[across_[0]] + ", " + turn[across_[1]] +
                   ", spin, mass, inertia, force, moment, ramp");
    }
  }
  for (int k = 0; k < 3; ++k)
    if (mode_[k] == free && mass_ == 0.0) args.fail(std::string(lab[k]) + " free needs 'mass M'");
  for (int k = 3; k < N_DOF; ++k)
    if (mode_[k] == free && inertia_.axial == 0.0)
      args.fail("a free tilt or spin needs 'inertia AXIAL TRANSVERSE'");
}

int FixBearingRing::setmask() { return INITIAL_INTEGRATE | POST_FORCE | FINAL_INTEGRATE; }

void FixBearingRing::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/ring");
  state_ = pair_->state();
  const std::string command = std::string("fix ") + id + " bearing/ring";
  own_.clear();
  for (int k = 0; k < N_VALUE; ++k) {
    value_[k].check(lmp, command);
    if (value_[k].by_atom()) own_.push_back(k);
  }
  grow_arrays(atom->nmax);    // atoms are sorted and exchanged before the values are known
  int by_another = 0;
  for (int k = 0; k < modify->nfix; ++k)
    if (strcmp(modify->fix[k]->style, "bearing/implicit") == 0)
      for (int i = 0; i < atom->nlocal; ++i)
        if ((atom->mask[i] & groupbit) && (atom->mask[i] & modify->fix[k]->groupbit))
          by_another = 1;
  MPI_Allreduce(MPI_IN_PLACE, &by_another, 1, MPI_INT, MPI_MAX,
                world);    // who owns no ring must know
  by_another_ = by_another;
  time_integrate = by_another_ ? 0 : 1;
  if (mass_ > 0.0)
    for (int i = 0; i < atom->nlocal; ++i)
      if (atom->mask[i] & groupbit) atom->rmass[i] = mass_;    // kinetic energy in thermo output
}

// Driven speeds hold from the first instant; forces of the set-up get the load like any others.
void FixBearingRing::setup(int vflag)
{
  find_own_values();
  evaluate(0, N_VALUE);
  before_ = now_;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) {
      const Values target = values(i);
      for (int k = 0; k < 3; ++k)
        if (mode_[k] == speed) atom->v[i][k] = target.of[k];
      if (mode_[SPIN_DOF] == speed) {
        const Vec3 e = state_->axis(i), w = Vec3::from(atom->omega[i]);
        const double missing = target.of[SPIN_DOF] - dot(w, e);
        // rounding of a run that goes on is left alone: its bits are those of the unbroken run
        if (std::fabs(missing) > 1e-14 * norm(w)) (w + e * missing).to(atom->omega[i]);
      }
    }
  post_force(vflag);
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
      if (!(atom->mask[i] & groupbit)) continue;
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

std::vector<FixBearingRing::OwnValue> FixBearingRing::own_values(int i) const
{
  std::vector<OwnValue> list;
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
  return per_ring_.capacity() * sizeof(Values) + tags_.capacity() * sizeof(int) +
         report_.capacity() * sizeof(double);
}

// Smooth growth of force and moment from 0 to full over the ramp time (3s^2 - 2s^3).
double FixBearingRing::ramp(double time) const
{
  if (time >= ramp_time_) return 1.0;
  const double s = time / ramp_time_;
  return s * s * (3.0 - 2.0 * s);
}

raceway::RingProgram FixBearingRing::program(const std::vector<OwnValue> &own) const
{
  Values of[2] = {before_, now_};
  for (const OwnValue &v : own) of[0].of[v.which] = of[1].of[v.which] = v.value;
  raceway::RingProgram p;
  p.mass = mass_;
  p.inertia = inertia_;
  p.ramp = ramp_time_;
  p.end = time_;
  p.length = update->dt;
  for (int k = 0; k < N_DOF; ++k) {
    const int lab = k < 3 ? (along_ + 1 + k) % 3 : k;
    p.mode[k] = static_cast<raceway::Freedom>(mode_[lab]);
    for (int end = 0; end < 2; ++end) p.target[end][k] = of[end].of[lab];
  }
  auto third = [this](const double *v) {
    return Vec3{v[(along_ + 1) % 3], v[(along_ + 2) % 3], v[along_]};
  };
  for (int end = 0; end < 2; ++end) {
    p.force[end] = third(of[end].of + FORCE);
    p.moment[end] = third(of[end].of + MOMENT);
  }
  return p;
}

void FixBearingRing::begin_step()
{
  time_ += update->dt;
  reported_ = -1;
  before_ = now_;
  evaluate(0, N_VALUE);
}

// Half a step of velocity from the forces; degrees of freedom that are not free ignore them.
void FixBearingRing::kick()
{
  const double half = 0.5 * update->dt * force->ftm2v;
  const bool tilts_free = mode_[3] == free && mode_[4] == free;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    for (int k = 0; k < 3; ++k)
      if (mode_[k] == free) atom->v[i][k] += half / mass_ * atom->f[i][k];
    const Vec3 e = state_->axis(i), M = Vec3::from(atom->torque[i]);
    Vec3 w = Vec3::from(atom->omega[i]);
    if (tilts_free) {
      // all of the gyroscopic coupling is in the momentum; an imposed spin takes its reaction
      const double spin = dot(w, e);
      w = raceway::angular_velocity(inertia_, raceway::angular_momentum(inertia_, w, e) + M * half,
                                    e);
      if (mode_[SPIN_DOF] != free) w += e * (spin - dot(w, e));
    } else {
      for (int k = 0; k < 2; ++k)
        if (mode_[3 + k] == free) {
          const Vec3 a = unit(across_[k]);
          w += a * (half / inertia_.transverse * dot(M, a));
        }
      if (mode_[SPIN_DOF] == free) w += e * (half / inertia_.axial * dot(M, e));
    }
    w.to(atom->omega[i]);
  }
}

// The rotation vector (rad, about the two lab axes across) that turns the bearing axis into e.
void FixBearingRing::tilt_of(const Vec3 &e, double *tilt) const
{
  const Vec3 s = cross(unit(along_), e);
  const double sine = norm(s),
               factor = sine > 0.0 ? std::atan2(sine, dot(unit(along_), e)) / sine : 1.0;
  for (int k = 0; k < 2; ++k) tilt[k] = factor * dot(s, unit(across_[k])) + 0.0;    // no minus zero
}

// Orientation over a step, and driven rotation speeds.
void FixBearingRing::turn(FixBearingState::RingMotion &ring, Vec3 &w, const double *target) const
{
  const double dt = update->dt;
  const bool free1 = mode_[3] == free, free2 = mode_[4] == free;
  const double spin = mode_[SPIN_DOF] == speed   ? target[SPIN_DOF]
                      : mode_[SPIN_DOF] == fixed ? 0.0
                                                 : dot(w, ring.axis);
  if (free1 && free2) {
    const Vec3 L = raceway::angular_momentum(inertia_, w, ring.axis);
    ring.axis = raceway::drift_axis(inertia_, L, ring.axis, dt);
    w = raceway::angular_velocity(inertia_, L, ring.axis);
    w += ring.axis * (spin - dot(w, ring.axis));
    tilt_of(ring.axis, ring.tilt);
  } else if (mode_[3] != fixed || mode_[4] != fixed) {
    Vec3 across;    // rotation velocity of the axis
    for (int k = 0; k < 2; ++k) {
      double rate = 0.0;
      if (mode_[3 + k] == free) rate = dot(w - ring.axis * dot(w, ring.axis), unit(across_[k]));
      if (mode_[3 + k] == speed) rate = target[3 + k];
      if (mode_[3 + k] == position) rate = (target[3 + k] - ring.tilt[k]) / dt;
      ring.tilt[k] += rate * dt;
      across += unit(across_[k]) * rate;
    }
    // two driven tilts define the axis outright: no drift from adding up small rotations
    ring.axis =
        rotate(unit(along_), unit(across_[0]) * ring.tilt[0] + unit(across_[1]) * ring.tilt[1]);
    w = across + ring.axis * spin;
  } else if (mode_[SPIN_DOF] != free) {
    w = ring.axis * spin;
  }
  ring.angle += spin * dt;
}

void FixBearingRing::initial_integrate(int)
{
  if (by_another_) return;
  const double dt = update->dt;
  time_ += dt;
  reported_ = -1;
  kick();
  evaluate(0, N_DOF);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const Values target = values(i);
    double *x = atom->x[i], *v = atom->v[i], origin[3];
    state_->ring(i).origin.to(origin);
    for (int k = 0; k < 3; ++k) {
      if (mode_[k] == fixed) v[k] = 0.0;
      if (mode_[k] == speed) v[k] = target.of[k];
      if (mode_[k] == position) {
        v[k] = (origin[k] + target.of[k] - x[k]) / dt;
        x[k] = origin[k] + target.of[k];
      } else {
        x[k] += dt * v[k];
      }
    }
    Vec3 w = Vec3::from(atom->omega[i]);
    turn(state_->ring(i), w, target.of);
    w.to(atom->omega[i]);
  }
}

void FixBearingRing::post_force(int)
{
  evaluate(FORCE, N_VALUE);
  const double share = ramp(time_);
  contact_force_.clear();
  contact_moment_.clear();
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) {
      contact_force_.push_back(Vec3::from(atom->f[i]));
      contact_moment_.push_back(Vec3::from(atom->torque[i]));
      const Values load = values(i);
      for (int k = 0; k < 3; ++k) {
        atom->f[i][k] += share * load.of[FORCE + k];
        atom->torque[i][k] += share * load.of[MOMENT + k];
      }
    }
}

void FixBearingRing::final_integrate()
{
  if (!by_another_) kick();
  reported_ = -1;    // a variable may have asked in the middle of the step
}

// Rings live on one rank each: a sum over ranks only moves their numbers.
void FixBearingRing::gather_reports()
{
  if (reported_ == update->ntimestep) return;
  reported_ = update->ntimestep;
  report_.assign(tags_.size() * N_REPORT, 0.0);
  size_t m = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!(atom->mask[i] & groupbit)) continue;
    const size_t row =
        std::lower_bound(tags_.begin(), tags_.end(), static_cast<int>(atom->tag[i])) -
        tags_.begin();
    double *r = &report_[row * N_REPORT];
    const FixBearingState::RingMotion &ring = state_->ring(i);
    const Vec3 w = Vec3::from(atom->omega[i]);
    (Vec3::from(atom->x[i]) - ring.origin).to(r + DX);
    Vec3::from(atom->v[i]).to(r + VX);
    tilt_of(ring.axis, r + TILT1);
    r[SPIN] = dot(w, ring.axis);
    r[ANGLE] = ring.angle;
    if (m < contact_force_.size()) {
      contact_force_[m].to(r + FX);
      contact_moment_[m].to(r + MX);
      r[FRICTION_TORQUE] = dot(contact_moment_[m], ring.axis);
    }
    ++m;
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
  return report_[row * N_REPORT + k];
}

void FixBearingRing::write_restart(FILE *fp)
{
  if (comm->me != 0) return;
  const int size = sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(&time_, sizeof(double), 1, fp);
}

void FixBearingRing::restart(char *buf) { memcpy(&time_, buf, sizeof(double)); }
