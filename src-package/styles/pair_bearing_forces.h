// SPDX-License-Identifier: GPL-2.0-or-later
// The loop over contacts of balls on raceways: place, motions, law, forces. What a scene does not
// ask for is a template parameter. Compiled apart for smooth raceways and for those with profiles.
#ifndef LMP_PAIR_BEARING_FORCES_H
#define LMP_PAIR_BEARING_FORCES_H

#include "pair_bearing_hertz.h"

#include "fix_bearing_state.h"

#include <algorithm>

namespace LAMMPS_NS {

template <class L, bool flawed> void PairBearingHertz::raceway_forces()
{
  using namespace raceway;
  double **x = atom->x, **v = atom->v, **w = atom->omega, **f = atom->f, **torque = atom->torque;
  // the forces of a set-up belong to a step already made: they must not advance what contacts keep
  const bool advance = !update->setupflag;
  const double dt = advance ? update->dt : 0.0;
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
    const bool keeps = L::states > 0 && advance && !(atom->mask[c.i_ball] & implicit_bits_);
    c.live = flawed && c.flawed() ? touch_profile(c, ball.x - ring.x, ring.e, on, turned)
                                  : touch(p, ball.x - ring.x, ring.e, c.state);
    if (c.live) {
      if (!(c.state.overlap < p.largest_overlap)) lost(c);
      ball.v = Vec3::from(v[c.i_ball]);
      ball.w = Vec3::from(w[c.i_ball]);
      ring.v = Vec3::from(v[c.i_ring]);
      ring.w = Vec3::from(w[c.i_ring]);
      if (offset != 0.0) ring.v += cross(ring.w, ring.e * offset);
      c.live = !approach<L>(p, ball, ring, c.state);
    }
    if (gaps_) look_at_gap(c);
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
    const LawStates<double> memory = {keeps ? dt : 0.0, c.kept, after};
    L::act(p, p.law.at(c.state.cos_angle), memory, c.state);
    ContactForces forces = assemble<L::couples>(p, ring.e, c.state);
    if (flawed && c.profile) push_along(on.slope, ring.e, c.state, forces);
    if (flawed && c.ball_profile) push_along(depth, ball.x - ring.x, c.state, forces);
    if (offset != 0.0) from_groove(ring.e, offset, forces);
    if (keeps) std::copy(after, after + L::states, c.kept);
    if (!std::isfinite(c.state.normal)) lost(c);
    forces.force.add_to(f[c.i_ball]);
    forces.ball_torque.add_to(torque[c.i_ball]);
    ring_sum_.add(c.claim, -forces.force, forces.ring_torque);
    if (evflag) {
      const Vec3 d = ball.x - ring.x;
      // only this rank sees the pair: count it whole (newton = 1)
      ev_tally_xyz(c.i_ball, c.i_ring, atom->nlocal, 1,
                   eflag_either ? L::energy(p, c.state) + (flawed && c.flawed() ? on.energy : 0.0)
                                : 0.0,
                   0.0, forces.force.x, forces.force.y, forces.force.z, d.x, d.y, d.z);
    }
  }
}

}    // namespace LAMMPS_NS

#endif
