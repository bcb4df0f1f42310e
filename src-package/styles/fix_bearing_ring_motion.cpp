// SPDX-License-Identifier: GPL-2.0-or-later
// The part of fix bearing/ring that acts within the host's step: velocity Verlet for rings, and the
// loads on rings with either integrator.
#include "fix_bearing_ring.h"

#include "../contacts/ring_motion.h"
#include "../core/bodies/ring_verlet.h"
#include "../ranks/gather.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::RingAtom;
using raceway::RingProgram;
using raceway::Vec3;

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

// Advances the velocities by half a step under the current forces.
void FixBearingRing::kick()
{
  const double half = 0.5 * update->dt * force->ftm2v;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i))
      write(i, kicked(settings_.program, read(i), axes_.third(Vec3::from(atom->f[i])),
                      axes_.third(Vec3::from(atom->torque[i])), half));
}

void FixBearingRing::initial_integrate(int)
{
  if (by_another_) return;
  note_setup();
  time_ += update->dt;
  reported_ = -1;
  between_.clear();
  kick();
  before_ = now_;
  evaluate(0, RingProgram::N_DOF);
  check_jumps();
  coast();
}

void FixBearingRing::coast()
{
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) write(i, coasted(at_end(i), read(i), update->dt));
}

void FixBearingRing::post_force(int)
{
  evaluate(RingProgram::FORCE, RingProgram::N_VALUE);
  // the sums over each ring are used, because other fixes may already have changed the forces in
  // atom->f
  const bearing::RingSum &sums = pair_->ring_sum();
  contacts_.clear();
  for (int n = 0; n < sums.rings(); ++n)
    if (moves(sums.ring(n)))
      contacts_.push_back({atom->tag[sums.ring(n)], sums.force(n), sums.torque(n)});
  add_loads();
}

void FixBearingRing::add_loads()
{
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      const RingProgram p = at_end(i);
      axes_.lab(load_of(p, i)).add_to(atom->f[i]);
      axes_.lab(p.moment_at(1.0, read(i))).add_to(atom->torque[i]);
    }
}

Vec3 FixBearingRing::load_of(const RingProgram &p, int i) const
{
  return p.force_at(1.0, state_->ring(i).angle);
}

void FixBearingRing::final_integrate()
{
  hold(by_another_ ? 0.0 : 0.5 * update->dt * force->ftm2v);
  if (!by_another_) kick();
  note_accelerations();
  noted_ = true;
  reported_ = -1;    // the report may already have been evaluated by a variable within the step
}

// The coordinates of a ring on which supports act, their rates, and the forces and moments along
// them.
struct Held {
  double moved[RingProgram::SPIN], rate[RingProgram::SPIN], push[RingProgram::SPIN];
};

static Held held(const RingAtom &r, const Vec3 &f, const Vec3 &m)
{
  const Vec3 d = r.x - r.origin, across = r.w - r.e * dot(r.w, r.e);
  return {{d.x, d.y, d.z, r.tilt[0], r.tilt[1]},
          {r.v.x, r.v.y, r.v.z, across.x, across.y},
          {f.x, f.y, f.z, m.x, m.y}};
}

// Adds the force and moment of the supports after all other forces. The velocities are `half`
// seconds old.
void FixBearingRing::hold(double half)
{
  if (!settings_.program.supported) return;
  if (holder_ != 0) return hold_between(half);
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      double on[RingProgram::SPIN];
      support_of(settings_.program, read(i), axes_.third(Vec3::from(atom->f[i])),
                 axes_.third(Vec3::from(atom->torque[i])), half, on);
      axes_.lab(Vec3{on[0], on[1], on[2]}).add_to(atom->f[i]);
      axes_.lab(Vec3{on[3], on[4], 0.0}).add_to(atom->torque[i]);
    }
}

// Does the same as hold() for supports that connect to another ring. All such supports are computed
// on all ranks, because the two rings may be on different ranks.
void FixBearingRing::hold_between(double half)
{
  struct End {
    bearing::tag_t tag;
    RingAtom at;
    Vec3 push, moment;
  };
  std::vector<End> ends;
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i) || atom->tag[i] == holder_)
      ends.push_back({atom->tag[i], read(i), axes_.third(Vec3::from(atom->f[i])),
                      axes_.third(Vec3::from(atom->torque[i]))});
  ends = bearing::gather_all(ends, world);
  std::sort(ends.begin(), ends.end(), [](const End &a, const End &b) { return a.tag < b.tag; });
  const auto holder =
      std::find_if(ends.begin(), ends.end(), [this](const End &e) { return e.tag == holder_; });
  const RingProgram &p = settings_.program, &other = holder_moves_by_->settings_.program;
  const Held ground = held(holder->at, holder->push, holder->moment);
  double all[RingProgram::SPIN] = {};
  for (const End &end : ends) {
    if (end.tag == holder_) continue;
    const Held ring = held(end.at, end.push, end.moment);
    double on[RingProgram::SPIN];
    for (int k = 0; k < RingProgram::SPIN; ++k) {
      on[k] = p.free(k)
                  ? verlet_support(
                        p.support[k],
                        {true, ring.moved[k], ring.rate[k], ring.push[k], p.inertia_of(k), {}},
                        {other.free(k), ground.moved[k], ground.rate[k], ground.push[k] + all[k],
                         other.inertia_of(k), other.support[k]},
                        half)
                  : 0.0;
      all[k] -= on[k];
    }
    add_support(end.tag, on);
  }
  holder_moves_by_->add_support(holder_, all);
}

// Adds the force and moment of a support to the ring on the rank that owns it, and to the output.
void FixBearingRing::add_support(bearing::tag_t ring, const double *on)
{
  const Vec3 force = {on[0], on[1], on[2]};
  between_[ring] += force;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->tag[i] == ring) {
      axes_.lab(force).add_to(atom->f[i]);
      axes_.lab(Vec3{on[3], on[4], 0.0}).add_to(atom->torque[i]);
    }
}

void FixBearingRing::support_of(const RingProgram &p, const RingAtom &r, const Vec3 &push,
                                const Vec3 &moment, double half, double *on)
{
  const Held at = held(r, push, moment);
  for (int k = 0; k < RingProgram::SPIN; ++k)
    on[k] = p.free(k) ? verlet_support(p.support[k], at.moved[k], at.rate[k], at.push[k],
                                       p.inertia_of(k), half)
                      : 0.0;
}

void FixBearingRing::note_setup()
{
  if (!noted_) note_accelerations();
  noted_ = true;
}

void FixBearingRing::note_accelerations()
{
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i))
      state_->ring(i).acceleration =
          axes_.lab(settings_.program.acceleration(axes_.third(Vec3::from(atom->f[i]))));
}
