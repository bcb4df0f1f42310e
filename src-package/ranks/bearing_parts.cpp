// SPDX-License-Identifier: GPL-2.0-or-later
// State of the bearings: from the owners of the atoms to the homes and back, every step. The
// finding of bearings is in bearing_parts_build.cpp.
#include "bearing_parts.h"

#include "../styles/pair_bearing_hertz.h"
#include "letters.h"

using namespace LAMMPS_NS;
using raceway::Vec3;

namespace bearing {

static constexpr int letters = 6208;    // message tag of this file alone

// States travel as numbers, as they lie in memory.
static constexpr size_t body_numbers = sizeof(BodyState) / sizeof(double);
static constexpr size_t ring_numbers = sizeof(RingFullState) / sizeof(double);
static_assert(body_numbers == 9 && ring_numbers == 19, "states are made of doubles");
static_assert(std::is_trivially_copyable<BodyState>::value &&
                  std::is_trivially_copyable<RingFullState>::value,
              "sent as they are");

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

void BearingParts::Letter::size_text()
{
  const size_t bodies = body_atom.size() + body_place.size(),
               rings = ring_atom.size() + ring_place.size();
  text.resize(bodies * body_numbers + rings * ring_numbers);
}

BodyState BearingParts::read_body(int i) const
{
  return {Vec3::from(atom->x[i]), Vec3::from(atom->v[i]), Vec3::from(atom->omega[i])};
}

RingFullState BearingParts::read_ring(int i) const
{
  return {Vec3::from(atom->x[i]), Vec3::from(atom->v[i]), Vec3::from(atom->omega[i]),
          pair_->state()->ring(i)};
}

void BearingParts::write_body(int i, const BodyState &b) const
{
  b.x.to(atom->x[i]);
  b.v.to(atom->v[i]);
  b.w.to(atom->omega[i]);
}

void BearingParts::write_ring(int i, const RingFullState &r) const
{
  r.x.to(atom->x[i]);
  r.v.to(atom->v[i]);
  r.w.to(atom->omega[i]);
  pair_->state()->ring(i) = r.motion;
}

void BearingParts::gather()
{
  for (const Local &l : own_bodies_) parts_[l.place.part].bodies[l.place.at] = read_body(l.i);
  for (const Local &l : own_rings_) parts_[l.place.part].rings[l.place.at] = read_ring(l.i);
  for (Letter &l : away_) {
    double *at = l.text.data();
    for (int i : l.body_atom) put(at, read_body(i));
    for (int i : l.ring_atom) put(at, read_ring(i));
  }
  deliver(away_, guests_, letters, world);
  for (const Letter &l : guests_) {
    const double *at = l.text.data();
    for (const Place &p : l.body_place) parts_[p.part].bodies[p.at] = take<BodyState>(at);
    for (const Place &p : l.ring_place) parts_[p.part].rings[p.at] = take<RingFullState>(at);
  }
}

void BearingParts::scatter()
{
  for (const Local &l : own_bodies_) write_body(l.i, parts_[l.place.part].bodies[l.place.at]);
  for (const Local &l : own_rings_) write_ring(l.i, parts_[l.place.part].rings[l.place.at]);
  for (Letter &l : guests_) {
    double *at = l.text.data();
    for (const Place &p : l.body_place) put(at, parts_[p.part].bodies[p.at]);
    for (const Place &p : l.ring_place) put(at, parts_[p.part].rings[p.at]);
  }
  deliver(guests_, away_, letters, world);
  for (const Letter &l : away_) {
    const double *at = l.text.data();
    for (int i : l.body_atom) write_body(i, take<BodyState>(at));
    for (int i : l.ring_atom) write_ring(i, take<RingFullState>(at));
  }
}

}    // namespace bearing
