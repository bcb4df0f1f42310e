// SPDX-License-Identifier: GPL-2.0-or-later
// Axes of a one-piece cage in the frame in which the forces on a ball are evaluated, and the
// motions of its points. T is double or Lane.
#pragma once

#include "../bodies/ring_implicit.h"

namespace raceway {

template <class T> struct alignas(sizeof(T)) CageAxesT {
  Vec3T<T> x, y, z;    // of the lab frame
  Vec3T<T> e;          // of the cage

  // Returns the velocity of a point at `lever` (m) from the centre per unit of a degree of freedom.
  RACEWAY_INLINE Vec3T<T> motion(int dof, const Vec3T<T> &lever) const
  {
    switch (dof) {
      case 0: return x;
      case 1: return y;
      case 2: return z;
      case RingProgram::TILT: return cross(x, lever);
      case RingProgram::TILT + 1: return cross(y, lever);
      default: return cross(e, lever);
    }
  }
};

}    // namespace raceway
