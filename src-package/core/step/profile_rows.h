// SPDX-License-Identifier: GPL-2.0-or-later
// Profiles of raceways and balls at four contacts: positions of the contacts on the profiles, and
// contributions of the profiles to the matrix.
#pragma once

#include "../bodies/ring_motions.h"
#include "bearing_system.h"

namespace raceway {

// Adds second-order terms to the matrix: with the motions p along the row `approach` and q along
// the row `path` (the first n of 6 numbers count), the energy cross p q + side q^2/2. The ring's
// degree of freedom `dof` moves the contact by changes(row, dof) along a row.
template <int n, class Changes>
static inline void add_rows(BearingSystem &system, BodyGroup &g, int group, const RingBody &ring,
                            const TurnRowT<Lane> &approach, const TurnRowT<Lane> &path,
                            const Lane &cross, const Lane &side, const Changes &changes)
{
  Lane G[6], t[6];
  approach.v.to(G);
  approach.w.to(G + 3);
  path.v.to(t);
  path.w.to(t + 3);
  for (int m = 0; m < n; ++m)
    for (int k = 0; k < n; ++k)
      g.A[6 * m + k] += cross * (G[m] * t[k] + t[m] * G[k]) + side * t[m] * t[k];
  if (!ring.loose) return;
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    const int u = ring.column[dof];
    if (u < 0) continue;
    const Lane along = changes(path, dof), near = changes(approach, dof), force_G = cross * along,
               force_t = cross * near + side * along;
    Lane *B = system.B(group, u), *C = system.C(group, u);
    for (int k = 0; k < n; ++k) {
      const Lane both = G[k] * force_G + t[k] * force_t;
      B[k] -= both;
      C[k] -= both;
    }
    for (int o = 0; o < RingProgram::N_DOF; ++o)
      if (ring.column[o] >= 0)
        system.D(ring.column[o], u) +=
            sum(changes(approach, o) * force_G + changes(path, o) * force_t);
  }
}

// Adds the contribution that is not included in the rows' profile slope: the change of the slope
// along the path of the ball's centre. h2 (s^2) is 0 without contact.
static inline void add_profile(BearingSystem &system, BodyGroup &g, int group, const RingBody &ring,
                               const Vec3L &d, const Vec3L &e, const ContactStateT<Lane> &c,
                               const Lane &h2, const ProfiledContactT<Lane> &on)
{
  const Vec3L lever = lever_of(ring, e, d);
  add_rows<3>(system, g, group, ring, {c.u * c.nu + e * c.ne - c.t * on.slope, Vec3L()},
              {c.t, Vec3L()}, h2 * on.cross, h2 * (on.side - c.normal * on.bend),
              [&](const TurnRowT<Lane> &row, int dof) {
                return dot(row.v, motion_of(dof, g.now, e, lever));
              });
}

static inline void put_lane(int i, const ProfiledContact &one, ProfiledContactT<Lane> &on)
{
  on.overlap[i] = one.overlap;
  on.slope[i] = one.slope;
  on.bend[i] = one.bend;
  on.energy[i] = one.energy;
  on.follows[i] = one.follows;
  on.cross[i] = one.cross;
  on.side[i] = one.side;
}

// Does the same for balls with profiles, along the row `path` for the azimuth in the balls'
// body-fixed axes.
static inline void add_ball_profile(BearingSystem &system, BodyGroup &g, int group,
                                    const RingBody &ring, const Vec3L &d, const Vec3L &e,
                                    const ContactStateT<Lane> &c, const Lane &h2, const Lane &slope,
                                    const TurnRowT<Lane> &depth, const BallSlopesT<Lane> &b)
{
  const Vec3L lever = lever_of(ring, e, d);
  add_rows<6>(system, g, group, ring, {c.u * c.nu + e * c.ne - c.t * slope - depth.v, -depth.w},
              turn_row(b.path_along, b.path_across, e, c), h2 * b.cross,
              h2 * (b.side - c.normal * b.bend), [&](const TurnRowT<Lane> &row, int dof) {
                return dot(row.v, motion_of(dof, g.now, e, lever)) +
                       dot(row.w, rotation_of(dof, g.now, e));
              });
}

// Finds the positions of the contacts on the profiles of the ring and of the balls.
static inline void look_at_profiles(const BearingBodies::Track &track,
                                    const BearingBodies::BallProfiles &balls,
                                    const BallTurns &turns, const LaneFrame &f,
                                    const RingPose &ring, const Vec3L &e,
                                    const ContactStateT<Lane> &c, ProfiledContactT<Lane> &on,
                                    BallSlopesT<Lane> &turned)
{
  const Vec3L u = f.lab(c.u), n = c.u * c.nu + e * c.ne, w = e * c.nu - c.u * c.ne;
  for (int i = 0; i < lanes; ++i) {
    const auto one_of = [i](const Vec3L &v) { return Vec3{v.x[i], v.y[i], v.z[i]}; };
    BallSlopes b;
    const ProfiledContact one = profiled(
        track.profile, balls.of[i], *track.physics, std::atan2(u.y[i], u.x[i]) - ring.angle, c.r[i],
        c.overlap[i], BallTurns::view(turns.now[i], one_of(n), one_of(c.t), one_of(w)), b);
    put_lane(i, one, on);
    turned.along[i] = b.along;
    turned.across[i] = b.across;
    turned.path_along[i] = b.path_along;
    turned.path_across[i] = b.path_across;
    turned.bend[i] = b.bend;
    turned.cross[i] = b.cross;
    turned.side[i] = b.side;
  }
}

static inline void look_at_profile(const BearingBodies::Track &track, const LaneFrame &f,
                                   const RingPose &ring, const ContactStateT<Lane> &c,
                                   ProfiledContactT<Lane> &on)
{
  const Vec3L u = f.lab(c.u);
  for (int i = 0; i < lanes; ++i) {
    const ProfiledContact one =
        profiled(*track.profile, *track.physics, std::atan2(u.y[i], u.x[i]) - ring.angle, c.r[i],
                 c.overlap[i]);
    put_lane(i, one, on);
  }
}

}    // namespace raceway
