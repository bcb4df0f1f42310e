// SPDX-License-Identifier: GPL-2.0-or-later
// How a ring's degrees of freedom move it, in the turning frame of a ball (lane_frame.h).
#ifndef RACEWAY_RING_MOTIONS_H
#define RACEWAY_RING_MOTIONS_H

#include "bearing_bodies.h"

namespace raceway {

// Angular velocity of a ring for a unit of a degree of freedom; e is its axis.
RACEWAY_INLINE Vec3L rotation_of(int dof, const LaneFrame &f, const Vec3L &e)
{
  const Lane none = {};
  switch (dof) {
    case RingProgram::TILT: return {f.c, -f.s, none};
    case RingProgram::TILT + 1: return {f.s, f.c, none};
    case RingProgram::SPIN: return e;
    default: return {none, none, none};
  }
}

// A lever from the ring's centre, from that of what moves as one with it.
RACEWAY_INLINE Vec3L lever_of(const RingBody &ring, const Vec3L &e, const Vec3L &lever)
{
  return ring.levered ? lever + e * ring.at : lever;
}

// Velocity of its point at `lever` from its centre.
RACEWAY_INLINE Vec3L motion_of(int dof, const LaneFrame &f, const Vec3L &e, const Vec3L &lever)
{
  const Lane one = all_lanes(1.0), none = {};
  switch (dof) {
    case 0: return {f.c, -f.s, none};
    case 1: return {f.s, f.c, none};
    case 2: return {none, none, one};
    default: return cross(rotation_of(dof, f, e), lever);
  }
}

}    // namespace raceway

#endif
