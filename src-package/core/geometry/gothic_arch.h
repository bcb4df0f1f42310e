// SPDX-License-Identifier: GPL-2.0-or-later
// A raceway of a four-point contact bearing: two grooves, of centres beside the middle plane, which
// a ball in the middle is in contact with at an angle. The ball is where one groove in the middle
// plane would hold it.
#ifndef RACEWAY_GOTHIC_ARCH_H
#define RACEWAY_GOTHIC_ARCH_H

#include <cmath>

namespace raceway {

struct GothicArch {
  double slack;    // m, groove radius less ball radius
  double angle;    // rad

  double offset() const { return slack * std::sin(angle); }    // m, of the groove centres
  // m, how much farther from the ball the bottoms of the grooves are than that of one groove
  double depth() const { return slack * (1.0 - std::cos(angle)); }
};

}    // namespace raceway

#endif
