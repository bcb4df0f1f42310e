// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_instants.h"

#include "../physics/capacitance.h"
#include "cubic.h"

namespace raceway {

void BearingInstants::want(const Instants &i)
{
  instants_ = i;
  if (i.number < 2) return;
  passed_.resize(b_.groups.size());
  looks_.assign((i.number - 1) * b_.n_contacts, Look());
}

InstantLoad BearingInstants::at(int k, int groove) const
{
  const Look &l = looks_[(k - 1) * b_.n_contacts + b_.contact_at[groove] / lanes];
  const int i = b_.contact_at[groove] % lanes;
  return {l.load[i], l.h_c[i], l.capacitance[i]};
}

void BearingInstants::pass(double h, double s0, double s1)
{
  const int n = instants_.number;
  if (n < 2) return;
  if (s0 == 0.0) next_ = 1;
  for (; next_ < n && (s1 == 1.0 || next_ <= s1 * n); ++next_) {
    const double s = (double(next_) / n - s0) / (s1 - s0);
    look_at(h, s < 1.0 ? s : 1.0, looks_.data() + (next_ - 1) * b_.n_contacts);
  }
}

RACEWAY_LANES void BearingInstants::look_at(double h, double s, Look *look)
{
  const Cubic at(s, h);
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    const BodyGroup &g = b_.groups[k];
    if (!g.spins) continue;    // cage balls
    Passed &p = passed_[k];
    p.frame.r = at(g.from.r, g.v_from.x, g.now.r, g.v.x);
    p.frame.z = at(g.from.z, g.v_from.z, g.now.z, g.v.z);
    p.frame.turn_from(g.from, at(Lane{}, Lane(g.v_from.y / g.from.r), Lane(g.turned + g.turn),
                                 Lane(g.v.y / g.now.r)));
    p.v = g.v_from + (g.v - g.v_from) * s;
    p.w = g.w_from + (g.w - g.w_from) * s;
  }
  for (const BearingBodies::Track &track : b_.tracks) {
    const RingBody &ring = b_.rings[track.ring];
    const RacewayPhysics &p = *track.physics;
    const RingPose pose = between(ring.from, ring.now, h, s);
    const Vec3 centre = pose.x - b_.centre, spin = pose.angular_velocity();
    for (int k = track.first; k < track.end; ++k, ++look) {
      const LaneFrame &f = passed_[k].frame;
      const Vec3L there = f.local(centre), d = {f.r - there.x, -there.y, f.z - there.z};
      RingStateT<Lane> r;
      r.e = f.local(pose.e);
      ContactStateT<Lane> c;
      locate(d, r.e, p.centre_circle, c);
      c.overlap = c.s - p.slack;
      const LaneMask live = b_.groups[k].used & (c.overlap > -p.reach);
      *look = Look();
      if (!any(live)) continue;
      c.overlap = where(live, c.overlap, 1e-9);
      r.v = f.local(pose.v);
      r.w = f.local(spin);
      const BallStateT<Lane> ball = {d, passed_[k].v, passed_[k].w};
      act<Law<HertzContactPart>>(p, ball, r, LawStates<Lane>(), c);
      look->load = where(live, c.load, 0.0);
      if (!p.has<FilmThicknessPart>()) continue;
      const FilmCapacitorT<Lane> q = film_capacitor(p, c, instants_.eps, instants_.shortest);
      look->h_c = where(live, q.h_c, 0.0);
      look->capacitance = where(live, q.capacitance, 0.0);
    }
  }
}

}    // namespace raceway
