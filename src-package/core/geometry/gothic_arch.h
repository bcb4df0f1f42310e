// SPDX-License-Identifier: GPL-2.0-or-later
// A raceway of a four-point contact bearing, which consists of two grooves whose centres lie
// outside the mid-plane. A ball in the mid-plane touches both at an angle; its position is the same
// as in a single groove centred in the mid-plane.
#pragma once

#include <cmath>

namespace raceway {

struct GothicArch {
  double slack;    // m, groove radius minus ball radius
  double angle;    // rad

  double offset() const { return slack * std::sin(angle); }    // m, offset of groove centres
  // Returns how much farther the bottoms of the two grooves lie from the ball than the bottom of
  // the single groove, m.
  double depth() const { return slack * (1.0 - std::cos(angle)); }
};

}    // namespace raceway
