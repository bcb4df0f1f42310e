// SPDX-License-Identifier: GPL-2.0-or-later
// The loop over contacts where raceways have profiles.
// Without forced inlining (physics/lane.h): with it, a compiler takes ten times as long.
#define RACEWAY_ONE_TARGET 1
#include "pair_bearing_forces.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;

// As touch(); where gaps are looked at the frame is set in any case.
bool PairBearingHertz::find_place(bearing::RacewayContact &c, const Vec3 &d, const Vec3 &e) const
{
  const RacewayPhysics &p = *c.raceway;
  if (!gaps_) return touch(p, d, e, c.state);
  locate(d, e, p.centre_circle, c.state);
  c.state.overlap = c.state.s - p.slack;
  return !(c.state.overlap <= -p.reach);
}

// Place, motions, law, forces of one contact after the other.
template <class L> void PairBearingHertz::flawed_forces()
{
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
    c.live = c.flawed() ? touch_profile(c, ball.x - ring.x, ring.e, on, turned)
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
    if (c.live && c.profile) c.state.overlap_rate -= on.slope * passing_speed(ball, ring, c.state);
    TurnRow depth;
    if (c.live && c.ball_profile) {
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
    if (c.profile) push_along(on.slope, ring.e, c.state, forces);
    if (c.ball_profile) push_along(depth, ball.x - ring.x, c.state, forces);
    if (offset != 0.0) from_groove(ring.e, offset, forces);
    if (keeps) std::copy(after, after + L::states, c.kept);
    add_forces<L>(c, forces, c.flawed() ? on.energy : 0.0);
  }
}

void PairBearingHertz::flawed_raceway_forces()
{
  with_law(law_, [this](auto law) { flawed_forces<decltype(law)>(); });
}
