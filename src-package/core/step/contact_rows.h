// SPDX-License-Identifier: GPL-2.0-or-later
// Expresses the slopes of a contact (core/contact/contact_slopes.h) as matrix rows for the
// velocities of the bodies.
//
// Local motions are rows that multiply the ball's velocity and spin: approach [n | 0], sliding [t |
// R w] and [w | -R t], rotations [0 | n], [0 | t], [0 | w]. The rows for a motion of the ring are
// the same, but with the velocity of the ring's contact point. If L contains the slopes of the
// local forces with respect to the local motions, the ball's block is rows^T L rows; the ring's
// columns and the border follow from the same product. A displacement also rotates the normal along
// which the force N acts: by 1/r per unit of displacement along the groove, and by 1/s per unit
// across it.
#pragma once

#include "../contact/contact_slopes.h"
#include "../numbers/lane_frame.h"

namespace raceway {

// Directions of a contact, and its slopes multiplied by h (s), which are 0 if there is no contact.
// Positions change with velocities for the time `follows` (s).
template <int n> struct ScaledSlopes {
  Vec3L normal, along, across;    // n, t, w
  Lane slope[n][n];
  Lane turn_along, turn_across;    // rotation of the normal
};

template <int n>
RACEWAY_INLINE ScaledSlopes<n> scaled(double h, double follows, const ContactStateT<Lane> &c,
                                      const Vec3L &e, const LaneMask &live,
                                      const ContactSlopesT<Lane, n> &slopes)
{
  ScaledSlopes<n> s;
  s.normal = c.u * c.nu + e * c.ne;
  s.along = c.t;
  s.across = e * c.nu - c.u * c.ne;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) s.slope[i][k] = where(live, Lane(h * slopes.of[i][k]), 0.0);
  const double turning = h * follows;
  const Lane N = where(live, Lane(turning * c.normal), 0.0);
  s.turn_along = N * c.nu / c.r;
  s.turn_across = N / c.s;
  return s;
}

// Computes the ball's rows, one for each local motion. The columns refer to the velocity and spin
// of the ball.
template <int n>
RACEWAY_INLINE void ball_rows(const ScaledSlopes<n> &s, double R, Lane (&row)[n][6])
{
  const Lane none = {};
  s.normal.to(row[0]);
  row[0][3] = row[0][4] = row[0][5] = none;
  s.along.to(row[1]);
  (s.across * R).to(row[1] + 3);
  s.across.to(row[2]);
  (s.along * -R).to(row[2] + 3);
  if constexpr (n == 6) {
    for (int k = 3; k < 6; ++k) row[k][0] = row[k][1] = row[k][2] = none;
    s.normal.to(row[3] + 3);
    s.along.to(row[4] + 3);
    s.across.to(row[5] + 3);
  }
}

// Computes the local forces per unit of a motion that is given by its local velocities. If
// `displaces` is true, they include the forces due to displacements.
template <int n>
RACEWAY_INLINE void local_forces(const ScaledSlopes<n> &s, const Lane (&motion)[n], bool displaces,
                                 Lane (&force)[n])
{
  for (int i = 0; i < n; ++i) {
    force[i] = s.slope[i][0] * motion[0];
    for (int k = 1; k < n; ++k) force[i] += s.slope[i][k] * motion[k];
  }
  if (!displaces) return;
  force[1] += s.turn_along * motion[1];
  force[2] += s.turn_across * motion[2];
}

}    // namespace raceway
