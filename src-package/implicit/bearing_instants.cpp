// SPDX-License-Identifier: GPL-2.0-or-later
// Loads, films and capacitances between two steps, for those who sample faster than the motion
// changes: places by the cubic through both ends of the internal step (cubic.h), velocities linear,
// and the contact formulas as anywhere else.
#include "../physics/capacitance.h"
#include "bearing_step.h"
#include "cubic.h"

namespace raceway {

void BearingStep::want(const Instants &i)
{
  instants_ = i;
  if (i.number < 2) return;
  passed_.resize(groups_.size());
  looks_.assign((i.number - 1) * touches_.size(), Look());
  look_of_.clear();
  for (const BearingModel::Groove &g : model_.grooves) {
    const int slot = slot_[g.body];
    int touch = 0;
    for (const Track &t : tracks_) {
      if (t.ring == g.ring && t.physics == g.physics && slot / lanes >= t.first &&
          slot / lanes < t.end)
        look_of_.push_back(lanes * (touch + slot / lanes - t.first) + slot % lanes);
      touch += t.end - t.first;
    }
  }
}

BearingStep::Contact BearingStep::at_instant(int k, int groove) const
{
  const Look &l = looks_[(k - 1) * touches_.size() + look_of_[groove] / lanes];
  const int i = look_of_[groove] % lanes;
  return {l.load[i], l.h_c[i], l.capacitance[i]};
}

// Those that the present step passes, before it becomes the past.
void BearingStep::look_at_instants()
{
  if (present_.s0 == 0.0) next_instant_ = 1;
  const int n = instants_.number;
  for (; next_instant_ < n && (present_.s1 == 1.0 || next_instant_ <= present_.s1 * n);
       ++next_instant_) {
    const double s = (double(next_instant_) / n - present_.s0) / (present_.s1 - present_.s0);
    look_at(s < 1.0 ? s : 1.0, looks_.data() + (next_instant_ - 1) * touches_.size());
  }
}

RACEWAY_LANES void BearingStep::look_at(double s, Look *look)
{
  const Cubic at(s, present_.h);
  for (size_t k = 0; k < groups_.size(); ++k) {
    const Group &g = groups_[k];
    if (!g.spins) continue;    // cage balls
    Passed &p = passed_[k];
    p.frame.r = at(g.from.r, g.v_from.x, g.now.r, g.v.x);
    p.frame.z = at(g.from.z, g.v_from.z, g.now.z, g.v.z);
    p.frame.turn_from(g.from, at(Lane{}, Lane(g.v_from.y / g.from.r), Lane(g.turned + g.turn),
                                 Lane(g.v.y / g.now.r)));
    p.v = g.v_from + (g.v - g.v_from) * s;
    p.w = g.w_from + (g.w - g.w_from) * s;
  }
  for (const Track &track : tracks_) {
    const Ring &ring = rings_[track.ring];
    const RacewayPhysics &p = *track.physics;
    const RingPose pose = between(ring.from, ring.now, present_.h, s);
    const Vec3 centre = pose.x - centre_, spin = pose.angular_velocity();
    for (int k = track.first; k < track.end; ++k, ++look) {
      const LaneFrame &f = passed_[k].frame;
      const Vec3L there = f.local(centre), d = {f.r - there.x, -there.y, f.z - there.z};
      RingStateT<Lane> r;
      r.e = f.local(pose.e);
      ContactStateT<Lane> c;
      locate(d, r.e, p.centre_circle, c);
      c.overlap = c.s - p.slack;
      const LaneMask live = groups_[k].used & (c.overlap > 0.0);
      *look = Look();
      if (!any(live)) continue;
      c.overlap = where(live, c.overlap, 1e-9);
      r.v = f.local(pose.v);
      r.w = f.local(spin);
      const BallStateT<Lane> ball = {d, passed_[k].v, passed_[k].w};
      contact_forces<false, Friction::none>(p, ball, r, FrictionSmoothed(), c);
      look->load = where(live, c.load, 0.0);
      if (!model_.lubricated) continue;
      const FilmCapacitorT<Lane> q = film_capacitor(p, c, instants_.eps, instants_.shortest);
      look->h_c = where(live, q.h_c, 0.0);
      look->capacitance = where(live, q.capacitance, 0.0);
    }
  }
}

}    // namespace raceway
