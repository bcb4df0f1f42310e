// SPDX-License-Identifier: GPL-2.0-or-later
// Queries for all raceways of a bearing. They do not depend on the contact law.
#include "../numbers/instruction_set.h"
#include "bearing_forces.h"
#include "bearing_system.h"

#include <algorithm>

namespace raceway {

Failure BearingForces::all_raceways(const Stage &stage)
{
#ifdef RACEWAY_TWO_TARGETS
  if (!wide_lanes()) return narrow_raceways(stage);
#endif
  Failure failure = Failure::none;
  const bool balance = stage.evaluate == Evaluate::only && !b_.balanced.empty();
  if (!b_.flawed && !balance && (paper_raceways(stage, failure) || full_raceways(stage, failure)))
    return failure;
  return any_raceways(stage);
}

// The step limit is evaluated in the current state.
double BearingForces::longest_step() const
{
  double longest = b_.ball_profiles.empty() ? HUGE_VAL : longest_step_of_balls();
  for (const BearingBodies::Track &track : b_.tracks) {
    if (!track.profile) continue;
    const RingPose &ring = b_.rings[track.ring].from;
    const double a[] = {ring.x.x - b_.centre.x, ring.x.y - b_.centre.y};
    for (int k = track.first; k < track.end; ++k)
      for (int i = 0; i < lanes; ++i) {
        const BodyGroup &g = b_.groups[k];
        const LaneFrame &f = g.from;
        const double phi = std::atan2(f.r[i] * f.s[i] - a[1], f.r[i] * f.c[i] - a[0]);
        longest = std::fmin(longest, track.profile->longest_step(
                                         phi - ring.angle, g.v_from.y[i] / f.r[i] - ring.spin));
      }
  }
  return longest;
}

double BearingForces::longest_step_of_balls() const
{
  double longest = HUGE_VAL;
  int contact = 0;
  for (const BearingBodies::Track &track : b_.tracks) {
    const RingPose &ring = b_.rings[track.ring].from;
    for (int k = track.first; k < track.end; ++k, ++contact) {
      const BearingBodies::BallProfiles &balls = b_.ball_profiles[contact];
      if (!balls.any) continue;
      const BodyGroup &g = b_.groups[k];
      const Vec3L x = g.from.place();
      for (int i = 0; i < lanes; ++i) {
        if (!balls.of[i]) continue;
        const Vec3 from_ring =
            in_lane(x, i) + b_.centre - ring.x - ring.e * track.physics->groove.offset;
        const GroovePosition p = locate(from_ring, ring.e, track.physics->centre_circle);
        const Vec3 lab = p.u * p.nu + ring.e * p.ne;
        const double c = g.from.c[i], s = g.from.s[i];
        const Vec3 n = {lab.x * c + lab.y * s, lab.y * c - lab.x * s, lab.z};
        const Quaternion back = b_.turns[b_.turns_at[k]].from[i].back();
        const Vec3 moves = back(cross(n, BallTurns::rate(g.v_from, g.w_from, g.from, i)));
        longest = std::fmin(longest, balls.of[i]->longest_step(back(n), moves));
      }
    }
  }
  return longest;
}

// Profiles are neglected, because they are shallow compared with the overlap of a loaded ball.
RACEWAY_LANES double BearingForces::largest_overlap() const
{
  Lane most = {};
  for (const BearingBodies::Track &track : b_.tracks) {
    const RingBody &ring = b_.rings[track.ring];
    const RacewayPhysics &p = *track.physics;
    Vec3 centre = ring.from.x - b_.centre;
    if (p.groove.offset != 0.0) centre += ring.from.e * p.groove.offset;
    for (int k = track.first; k < track.end; ++k) {
      const BodyGroup &g = b_.groups[k];
      const LaneFrame &f = g.from;
      const Vec3L at = f.local(centre);
      ContactStateT<Lane> c;
      locate({f.r - at.x, -at.y, f.z - at.z}, f.local(ring.from.e), p.centre_circle, c);
      out_of_reach(p, c);
      most = where(g.used & (c.overlap > most), c.overlap, most);
    }
  }
  return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

RACEWAY_LANES bool BearingForces::follow(double exact)
{
  if (b_.states() == 0) return true;
  LaneMask rough = {};
  int contact = 0;
  for (const BearingBodies::Track &track : b_.tracks) {
    const RingBody &ring = b_.rings[track.ring];
    double y[RingProgram::N_DOF];
    for (int dof = 0; dof < RingProgram::N_DOF; ++dof)
      y[dof] = ring.column[dof] < 0 ? 0.0 : system_.motion(ring.column[dof]);
    const Vec3 ring_v = {y[0], y[1], y[2]},
               ring_w = Vec3{y[RingProgram::TILT], y[RingProgram::TILT + 1], 0.0} +
                        ring.now.e * y[RingProgram::SPIN];
    const double radius = track.physics->groove.ball_radius;
    for (int k = track.first; k < track.end; ++k, ++contact) {
      const KeptSlopes &s = b_.kept_slopes[contact];
      if (!any(s.live)) continue;
      const BodyGroup &g = b_.groups[k];
      Lane motion[6];
      motions_of(
          s, radius,
          {Vec3L::from(g.rhs), Vec3L::from(g.rhs + 3), g.now.local(ring_v), g.now.local(ring_w)},
          motion);
      if (track.profile)
        motion[0] -=
            s.slope * dot(s.along, Vec3L::from(g.rhs) - g.now.local(ring_v) -
                                       cross(g.now.local(ring_w), s.lever - s.normal * radius));
      if (!b_.ball_profiles.empty() && b_.ball_profiles[contact].any) {
        const TurnRowT<Lane> &depth = b_.ball_rows[contact];
        const Vec3L w = g.now.local(ring_w);
        motion[0] -= dot(depth.v, Vec3L::from(g.rhs) - g.now.local(ring_v) -
                                      cross(w, s.lever - s.normal * radius)) +
                     dot(depth.w, Vec3L::from(g.rhs + 3) - w);
      }
      for (int m = 0; m < b_.states(); ++m) {
        Lane change = s.of[m][0] * motion[0];
        for (int i = 1; i < 6; ++i) change += s.of[m][i] * motion[i];
        b_.kept[contact].now[m] += where(s.live, change, 0.0);
        rough |= s.live & (magnitude(change) > s.stiffness * exact);
      }
    }
  }
  return !any(rough);
}

}    // namespace raceway
