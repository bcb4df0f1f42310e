// SPDX-License-Identifier: GPL-2.0-or-later
// A raceway of a four-point contact bearing: two grooves with centres off the middle plane. A ball
// in the middle plane touches both at an angle; it has the same position as in a single groove in
// the middle plane.
#ifndef RACEWAY_GOTHIC_ARCH_H
#define RACEWAY_GOTHIC_ARCH_H

#include <cmath>

namespace raceway {

struct GothicArch {
  double slack;    // m, groove radius minus ball radius
  double angle;    // rad

  double offset() const { return slack * std::sin(angle); }    // m, of the groove centres
  // Distance of the bottoms of the grooves beyond the bottom of the single groove, m.
  double depth() const { return slack * (1.0 - std::cos(angle)); }
};

}    // namespace raceway

#endif
