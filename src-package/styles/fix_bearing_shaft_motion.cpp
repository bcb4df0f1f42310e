// SPDX-License-Identifier: GPL-2.0-or-later
// The part of fix bearing/shaft that acts within the host's step: conversion between the states of
// the rings and the state of the shaft, velocity Verlet, and the loads with either integrator.
#include "fix_bearing_shaft.h"

#include "../contacts/ring_motion.h"
#include "../core/bodies/ring_verlet.h"
#include "../core/bodies/shaft_ring.h"
#include "../core/figures/fix_columns.h"
#include "../ranks/gather.h"
#include "fix_bearing_state.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::RingAtom;
using raceway::RingPose;
using raceway::RingProgram;
using raceway::Vec3;

int FixBearingShaft::first_ring() const
{
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i) && atom->tag[i] == tags_.front()) return i;
  return -1;
}

// Returns all rings on all ranks, sorted by tag.
std::vector<FixBearingShaft::MountedRing> FixBearingShaft::rings() const
{
  std::vector<MountedRing> mine;
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!moves(i)) continue;
    MountedRing r = {atom->tag[i],
                     place_on_shaft(i),
                     read(i),
                     axes_.third(Vec3::from(atom->f[i])),
                     axes_.third(Vec3::from(atom->torque[i])),
                     {}};
    for (const ContactLoad &c : contacts_)
      if (c.ring == r.tag) {
        r.contact[0] = axes_.third(c.force);
        r.contact[1] = axes_.third(c.moment);
      }
    mine.push_back(r);
  }
  std::vector<MountedRing> all = bearing::gather_all(mine, world);
  std::sort(all.begin(), all.end(),
            [](const MountedRing &a, const MountedRing &b) { return a.tag < b.tag; });
  return all;
}

FixBearingShaft::Whole FixBearingShaft::whole() const
{
  Whole w;
  w.rings = rings();
  w.shaft = straight(w.rings.front().now, w.rings.front().at);
  const Vec3 &e = w.shaft.e;
  for (const MountedRing &r : w.rings) {
    w.push += r.force;
    w.moment += moment_about_centre(e, r.at, r.force, r.moment);
    w.contact[0] += r.contact[0];
    w.contact[1] += moment_about_centre(e, r.at, r.contact[0], r.contact[1]);
  }
  return w;
}

void FixBearingShaft::move_rings(const RingAtom &shaft)
{
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i))
      write(i, raceway::carried(shaft, place_on_shaft(i), axes_.third(state_->ring(i).origin)));
}

// Adds the loads that act on the shaft as a whole to the atom of its first ring.
void FixBearingShaft::add_to_first(const RingAtom &shaft, const Vec3 &push, const Vec3 &moment)
{
  const int i = first_ring();
  if (i < 0) return;
  axes_.lab(push).add_to(atom->f[i]);
  axes_.lab(moment - cross(shaft.e * place_on_shaft(i), push)).add_to(atom->torque[i]);
}

void FixBearingShaft::set_grain_load(const Vec3 &force, const Vec3 &moment)
{
  settings_.program.grains = true;
  settings_.program.grain_force = force;
  settings_.program.grain_moment = moment;
}

void FixBearingShaft::kick()
{
  const Whole w = whole();
  between_ = kicked(settings_.program, w.shaft, w.push, w.moment, 0.5 * update->dt * force->ftm2v);
  move_rings(between_);
}

void FixBearingShaft::coast() { move_rings(coasted(at_end(now_), between_, update->dt)); }

void FixBearingShaft::add_loads()
{
  const int i = first_ring();
  if (i < 0) return;
  const RingAtom shaft = straight(read(i), place_on_shaft(i));
  const RingProgram p = at_end(now_);
  add_to_first(shaft, p.force_at(1.0, shaft.angle), p.moment_at(1.0, shaft));
}

void FixBearingShaft::hold(double half)
{
  if (!settings_.program.supported) return;
  const Whole w = whole();
  double on[RingProgram::SPIN];
  support_of(settings_.program, at_centre(w.shaft), w.push, w.moment, half, on);
  add_to_first(w.shaft, {on[0], on[1], on[2]}, {on[3], on[4], 0.0});
}

static RingPose pose_of(const RingAtom &shaft)
{
  RingPose pose;
  static_cast<raceway::RingPlace &>(pose) = shaft;
  pose.set_angular_velocity(shaft.w);
  return pose;
}

void FixBearingShaft::note_accelerations()
{
  const Whole w = whole();
  const RingProgram p = at_end(now_);
  const RingPose shaft = pose_of(w.shaft), held = pose_of(at_centre(w.shaft));
  // the torques of the atoms are not used, because they contain the effect of gravity on the rings
  Vec3 moment = w.contact[1] + p.moment_at(1.0, shaft);
  if (p.supported) moment += p.support_moment(held, held.rate[0], held.rate[1]);
  std::vector<double> on_modes;
  if (bending()) {
    moment += moment_of_modes(modes(), bend_, shaft.spin);
    on_modes = forces_on_modes(w.rings, shaft);
    if (p.supported) add_supports(modes().station(0.0), p, held, on_modes);
  }
  for (int i = 0; i < atom->nlocal; ++i)
    if (moves(i)) {
      const double at = place_on_shaft(i);
      Vec3 a = carried_acceleration(p, shaft, at, w.push, moment);
      if (bending()) a += bending_acceleration(modes(), modes().station(at), on_modes);
      state_->ring(i).acceleration = axes_.lab(a);
    }
}

double FixBearingShaft::compute_vector(int k)
{
  using bearing::of_fix_ring::N;
  return k < N ? reported(static_cast<int>(tags_.size()), k) : bending_value(k - N);
}

// Writes one row for every ring, and then one row for the shaft.
void FixBearingShaft::make_report()
{
  FixBearingRing::make_report();
  using namespace bearing::of_fix_ring;
  const Whole w = whole();
  const RingProgram p = at_end(now_);
  const RingPose shaft = pose_of(w.shaft);
  double r[N] = {};
  axes_.lab(shaft.x - shaft.origin).to(r + X);
  axes_.lab(shaft.v).to(r + VX);
  raceway::tilt_of(shaft.e, r + TILT1);
  r[SPIN] = shaft.spin;
  r[ANGLE] = shaft.angle;
  axes_.lab(w.contact[0]).to(r + FX);
  axes_.lab(w.contact[1]).to(r + MX);
  r[TORQUE] = dot(w.contact[1], shaft.e);
  axes_.lab(p.force_at(1.0, shaft.angle)).to(r + LOAD_X);
  if (p.supported) axes_.lab(p.support_force(pose_of(at_centre(w.shaft)))).to(r + SUPPORT_X);
  axes_.lab(p.acceleration(w.push)).to(r + AX);
  report_.insert(report_.end(), r, r + N);
}
