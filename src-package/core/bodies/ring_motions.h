// SPDX-License-Identifier: GPL-2.0-or-later
// Ring motion for each degree of freedom, in the rotating frame of a ball (lane_frame.h).
#pragma once

#include "bearing_bodies.h"

namespace raceway {

// Returns the angular velocity of a ring per unit of a degree of freedom; e is its axis.
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

// Converts a lever from the ring's centre to a lever from the centre of the ring or its shaft.
RACEWAY_INLINE Vec3L lever_of(const RingBody &ring, const Vec3L &e, const Vec3L &lever)
{
  return ring.levered ? lever + e * ring.at : lever;
}

// Returns the velocity of the point of the ring at `lever` from the ring's centre.
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
