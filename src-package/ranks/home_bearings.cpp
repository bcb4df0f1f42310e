// SPDX-License-Identifier: GPL-2.0-or-later
// Sends the state of the bearings from the owners of the atoms to the home ranks and back in every
// step. Finding the bearings is implemented in home_bearings_build.cpp.
#include "home_bearings.h"

#include "letters.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::BodyPose;
using raceway::RingPose;
using raceway::Vec3;

namespace bearing {

static constexpr int pose_letters = 6208;    // MPI message tag, used only in this file

// States are sent as raw memory, which is interpreted as numbers.
static_assert(std::is_trivially_copyable<BodyPose>::value &&
                  std::is_trivially_copyable<RingPose>::value,
              "sent as they are");
template <class State> static constexpr size_t numbers()
{
  static_assert(sizeof(State) % sizeof(double) == 0, "made of doubles");
  return sizeof(State) / sizeof(double);
}

template <class State> static void put(double *&at, const State &s)
{
  memcpy(at, &s, sizeof s);
  at += sizeof s / sizeof *at;
}

template <class State> static State take(const double *&at)
{
  State s;
  memcpy(static_cast<void *>(&s), at, sizeof s);
  at += sizeof s / sizeof *at;
  return s;
}

void HomeBearings::Letter::size_text(int states)
{
  const size_t bodies = body_atom.size() + body_place.size(),
               rings = ring_atom.size() + ring_place.size(),
               contacts = kept.size() + contact_place.size();
  text.resize(bodies * numbers<BodyPose>() + rings * numbers<SentRing>() + contacts * states);
}

BodyPose HomeBearings::read_body(int i) const
{
  const raceway::LabAxes &axes = sources_.axes;
  return {axes.third(Vec3::from(atom->x[i])), axes.third(Vec3::from(atom->v[i])),
          axes.third(Vec3::from(atom->omega[i])),
          sources_.turn ? sources_.turn(i) : raceway::Quaternion()};
}

HomeBearings::SentRing HomeBearings::read_ring(int i) const
{
  const RingMotion &m = sources_.motion(i);
  SentRing r;
  read_place(*atom, i, m, sources_.axes, r.pose);
  r.pose.set_angular_velocity(sources_.axes.third(Vec3::from(atom->omega[i])));
  r.step = m.step;
  return r;
}

void HomeBearings::write_body(int i, const BodyPose &b) const
{
  const raceway::LabAxes &axes = sources_.axes;
  axes.lab(b.x).to(atom->x[i]);
  axes.lab(b.v).to(atom->v[i]);
  axes.lab(b.w).to(atom->omega[i]);
  if (sources_.turn) sources_.turn(i) = b.turn;
}

void HomeBearings::write_ring(int i, const SentRing &r) const
{
  RingMotion &m = sources_.motion(i);
  write_place(r.pose, sources_.axes, *atom, i, m);
  sources_.axes.lab(r.pose.angular_velocity()).to(atom->omega[i]);
  m.step = r.step;
}

HomeBearings::SentRing HomeBearings::ring_at(const Place &p) const
{
  return {bearings_[p.bearing].rings[p.at], bearings_[p.bearing].steps[p.at]};
}

void HomeBearings::put_ring(const Place &p, const SentRing &r)
{
  bearings_[p.bearing].rings[p.at] = r.pose;
  bearings_[p.bearing].steps[p.at] = r.step;
}

void HomeBearings::gather()
{
  for (const Local &l : own_bodies_) bearings_[l.place.bearing].bodies[l.place.at] = read_body(l.i);
  for (const Local &l : own_rings_) put_ring(l.place, read_ring(l.i));
  const int n = sources_.states;
  for (const LocalContact &l : own_contacts_) std::copy(l.kept, l.kept + n, states_at(l.place));
  for (Letter &l : away_) {
    double *at = l.text.data();
    for (int i : l.body_atom) put(at, read_body(i));
    for (int i : l.ring_atom) put(at, read_ring(i));
    for (const double *kept : l.kept) at = std::copy(kept, kept + n, at);
  }
  deliver(away_, guests_, pose_letters, world);
  for (const Letter &l : guests_) {
    const double *at = l.text.data();
    for (const Place &p : l.body_place) bearings_[p.bearing].bodies[p.at] = take<BodyPose>(at);
    for (const Place &p : l.ring_place) put_ring(p, take<SentRing>(at));
    for (const Place &p : l.contact_place) {
      std::copy(at, at + n, states_at(p));
      at += n;
    }
  }
}

void HomeBearings::scatter()
{
  for (const Local &l : own_bodies_) write_body(l.i, bearings_[l.place.bearing].bodies[l.place.at]);
  for (const Local &l : own_rings_) write_ring(l.i, ring_at(l.place));
  const int n = sources_.states;
  for (const LocalContact &l : own_contacts_)
    std::copy(states_at(l.place), states_at(l.place) + n, l.kept);
  for (Letter &l : guests_) {
    double *at = l.text.data();
    for (const Place &p : l.body_place) put(at, bearings_[p.bearing].bodies[p.at]);
    for (const Place &p : l.ring_place) put(at, ring_at(p));
    for (const Place &p : l.contact_place) at = std::copy(states_at(p), states_at(p) + n, at);
  }
  deliver(guests_, away_, pose_letters, world);
  for (const Letter &l : away_) {
    const double *at = l.text.data();
    for (int i : l.body_atom) write_body(i, take<BodyPose>(at));
    for (int i : l.ring_atom) write_ring(i, take<SentRing>(at));
    for (double *kept : l.kept) {
      std::copy(at, at + n, kept);
      at += n;
    }
  }
}

}    // namespace bearing
