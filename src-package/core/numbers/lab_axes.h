// SPDX-License-Identifier: GPL-2.0-or-later
// Converts between the axes of the lab frame (x, y, z) and axes of which the third is the bearing
// axis. The permutation is cyclic, so right-handed axes remain right-handed and no values change.
#pragma once

#include "vec3.h"

namespace raceway {

struct LabAxes {
  int along = 2;    // axis of the lab frame along which the bearing lies: 0 x, 1 y, 2 z

  // Returns the axis of the lab frame that corresponds to component k in axes whose third axis is
  // the bearing axis.
  int lab_axis(int k) const { return (along + 1 + k) % 3; }
  Vec3 third(const Vec3 &lab) const
  {
    return along == 2 ? lab : along == 0 ? Vec3{lab.y, lab.z, lab.x} : Vec3{lab.z, lab.x, lab.y};
  }
  Vec3 lab(const Vec3 &third) const
  {
    return along == 2   ? third
           : along == 0 ? Vec3{third.z, third.x, third.y}
                        : Vec3{third.y, third.z, third.x};
  }
};

}    // namespace raceway
