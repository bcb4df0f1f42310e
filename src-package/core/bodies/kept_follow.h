// SPDX-License-Identifier: GPL-2.0-or-later
// Updates the states of contacts after the last correction. The states (core/parts/part.h) depend
// on the velocities at the end of a stage. The last evaluation gives the states and their slopes at
// the velocities before the last correction. The first-order update in this file gives the states
// that belong to the solution of the stage, so that momentum and contact forces are consistent.
// Without this update, a stiff tangential spring would lag by one correction, as in an explicit
// step, and would be unstable.
#pragma once

#include "../contact/contact_slopes.h"
#include "../numbers/lane_frame.h"

namespace raceway {

struct alignas(32) KeptSlopes {    // for four contacts, from the last evaluation with derivatives
  Vec3L normal, along, across,
      lever;         // lever: from the centre of the ring or its shaft to the contact, m
  Lane slope;        // slope of a profile along the path (profiled_contact.h)
  Lane stiffness;    // N/m, stiffness of the elastic contact
  LaneMask live;     // contacts closed in the last evaluation
  Lane of[most_states][6];
};

// Changes in velocity due to a correction, in the ball's frame.
struct Correction {
  Vec3L v, w;              // m/s, rad/s, of the balls
  Vec3L ring_v, ring_w;    // of the ring
};

// Converts a correction to motions of the contacts, in the order defined in contact_slopes.h.
RACEWAY_INLINE void motions_of(const KeptSlopes &s, double radius, const Correction &c,
                               Lane (&motion)[6])
{
  const Vec3L v = c.v - c.ring_v - cross(c.ring_w, s.lever), w = c.w - c.ring_w;
  motion[0] = dot(s.normal, v);
  motion[1] = dot(s.along, v) + radius * dot(s.across, c.w);
  motion[2] = dot(s.across, v) - radius * dot(s.along, c.w);
  motion[3] = dot(s.normal, w);
  motion[4] = dot(s.along, w);
  motion[5] = dot(s.across, w);
}

}    // namespace raceway
