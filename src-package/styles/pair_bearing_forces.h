// SPDX-License-Identifier: GPL-2.0-or-later
// The loop over contacts of balls on raceways: place, motions, law, forces. What a scene does not
// ask for is a template parameter. Compiled apart for smooth raceways and for those with profiles.
#ifndef LMP_PAIR_BEARING_FORCES_H
#define LMP_PAIR_BEARING_FORCES_H

#include "pair_bearing_hertz.h"

#include "../implicit/contact_lanes.h"
#include "../implicit/lanes_apart.h"
#include "fix_bearing_state.h"

#include <algorithm>

namespace LAMMPS_NS {

// Room for four contacts side by side, and for the lanes that stand idle.
struct PairBearingHertz::InLanes {
  raceway::ContactLanes four;
  raceway::ContactState state[raceway::lanes];
  raceway::ContactForces force[raceway::lanes];
};

template <class L>
inline void PairBearingHertz::add_forces(const bearing::RacewayContact &c,
                                         const raceway::ContactForces &forces,
                                         double energy_of_profile)
{
  if (!std::isfinite(c.state.normal)) lost(c);
  forces.force.add_to(atom->f[c.i_ball]);
  forces.ball_torque.add_to(atom->torque[c.i_ball]);
  ring_sum_.add(c.claim, -forces.force, forces.ring_torque);
  if (evflag) tally(c, forces, L::energy(*c.raceway, c.state) + energy_of_profile);
}

// As touch(); where gaps are looked at the frame is set in any case.
inline bool PairBearingHertz::find_place(bearing::RacewayContact &c, const raceway::Vec3 &d,
                                         const raceway::Vec3 &e) const
{
  const raceway::RacewayPhysics &p = *c.raceway;
  if (!gaps_) return touch(p, d, e, c.state);
  locate(d, e, p.centre_circle, c.state);
  c.state.overlap = c.state.s - p.slack;
  return !(c.state.overlap <= -p.reach);
}

inline double PairBearingHertz::orbit_of(const bearing::RacewayContact &c) const
{
  using raceway::Vec3;
  return dot(Vec3::from(atom->v[c.i_ball]) - Vec3::from(atom->v[c.i_ring]), c.state.t) / c.state.r;
}

template <class L, bool flawed> void PairBearingHertz::raceway_forces()
{
  using namespace raceway;
  double **x = atom->x, **v = atom->v, **w = atom->omega;
  BallState ball;
  RingState ring;
  ProfiledContact on;
  BallSlopes turned;    // of a ball with a profile
  for (bearing::RacewayContact &c : table_.raceway) {
    const RacewayPhysics &p = *c.raceway;
    ball.x = Vec3::from(x[c.i_ball]);
    ring.x = Vec3::from(x[c.i_ring]);
    ring.e = state_->axis(c.i_ring);
    const double offset = p.groove.offset;
    if (offset != 0.0) ring.x += ring.e * offset;
    const bool keeps = L::states > 0 && advances(c);
    c.live = flawed && c.flawed() ? touch_profile(c, ball.x - ring.x, ring.e, on, turned)
                                  : find_place(c, ball.x - ring.x, ring.e);
    if (c.live || gaps_) {
      if (c.live && !(c.state.overlap < p.largest_overlap)) lost(c);
      ball.v = Vec3::from(v[c.i_ball]);
      ball.w = Vec3::from(w[c.i_ball]);
      ring.v = Vec3::from(v[c.i_ring]);
      ring.w = Vec3::from(w[c.i_ring]);
      if (offset != 0.0) ring.v += cross(ring.w, ring.e * offset);
      if (c.live) c.live = !approach<L>(p, ball, ring, c.state);
      else find_motions<false>(p, ball, ring, c.state);
      if (gaps_) c.orbit = orbit_of(c);
    }
    if (flawed && c.live && c.profile)
      c.state.overlap_rate -= on.slope * passing_speed(ball, ring, c.state);
    TurnRow depth;
    if (flawed && c.live && c.ball_profile) {
      depth = turn_row(turned.along, turned.across, ring.e, c.state);
      c.state.overlap_rate -= depth.rate(ball, ring, ball.x - ring.x);
    }
    if (!c.live) {
      if (keeps) std::fill(c.kept, c.kept + L::states, 0.0);
      continue;
    }
    double after[L::states > 0 ? L::states : 1];
    const LawStates<double> memory = {keeps ? update->dt : 0.0, c.kept, after};
    L::act(p, p.law.at(c.state.cos_angle), memory, c.state);
    ContactForces forces = assemble<L::couples>(p, ring.e, c.state);
    if (flawed && c.profile) push_along(on.slope, ring.e, c.state, forces);
    if (flawed && c.ball_profile) push_along(depth, ball.x - ring.x, c.state, forces);
    if (offset != 0.0) from_groove(ring.e, offset, forces);
    if (keeps) std::copy(after, after + L::states, c.kept);
    add_forces<L>(c, forces, flawed && c.flawed() ? on.energy : 0.0);
  }
}

// Of the contacts of one raceway that touch, four at a time. Forces are added in the table's order.
template <class L> void PairBearingHertz::forces_in_lanes()
{
  using namespace raceway;
  using bearing::RacewayContact;
  std::vector<RacewayContact> &table = table_.raceway;
  found_.resize(table.size());
  if (!in_lanes_) in_lanes_ = std::make_shared<InLanes>();
  ContactLanes &four = in_lanes_->four;
  int count = 0, at[lanes];
  const auto act = [&] {
    if (count == 0) return;
    RacewayContact &first = table[at[0]];
    for (int i = count; i < lanes; ++i) put(first, ball_of(first), groove_of(first), i, four);
    const bool keeps = advances(first);
    four.dt = keeps ? update->dt : 0.0;
    act_in_lanes(*first.raceway, four);
    ContactState *states[lanes];
    ContactForces *forces[lanes];
    for (int i = 0; i < lanes; ++i) {
      states[i] = i < count ? &table[at[i]].state : &in_lanes_->state[i];
      forces[i] = i < count ? &found_[at[i]] : &in_lanes_->force[i];
    }
    lanes_apart(four.state, states);
    lanes_apart(four.forces, forces);
    const double offset = first.raceway->groove.offset;
    for (int i = 0; i < count; ++i) {
      if (offset != 0.0) from_groove(state_->axis(table[at[i]].i_ring), offset, *forces[i]);
      table[at[i]].live = four.live[i];
      for (int k = 0; keeps && k < L::states; ++k) table[at[i]].kept[k] = four.after[k][i];
    }
    count = 0;
  };
  for (const int n : by_raceway_) {
    RacewayContact &c = table[n];
    const BallState ball = ball_of(c);
    const RingState groove = groove_of(c);
    c.live = find_place(c, ball.x - groove.x, groove.e);
    if (gaps_) c.orbit = orbit_of(c);
    if (!c.live) {
      if (gaps_) find_motions<false>(*c.raceway, ball, groove, c.state);
      continue;
    }
    if (!(c.state.overlap < c.raceway->largest_overlap)) lost(c);
    if (count == lanes ||
        (count > 0 && (table[at[0]].raceway != c.raceway || advances(table[at[0]]) != advances(c))))
      act();
    put(c, ball, groove, count, four);
    at[count++] = n;
  }
  act();
  for (size_t n = 0; n < table.size(); ++n) {
    RacewayContact &c = table[n];
    if (c.live) add_forces<L>(c, found_[n], 0.0);
    else if (advances(c)) std::fill(c.kept, c.kept + L::states, 0.0);
  }
}

}    // namespace LAMMPS_NS

#endif
