// SPDX-License-Identifier: GPL-2.0-or-later
// SKF's starvation factor phi_rs for the rolling couple (Rolling bearings, 10000 EN, 2013). K_rs is
// 3e-8 for an oil bath or jet and 6e-8 for grease and oil-air; K_Z depends on the bearing type.
#pragma once

#include <cmath>

namespace raceway {

constexpr double deep_slender = 3.1, angular_slender = 4.4;    // K_Z; single-row angular contact

// The bore and the outside diameter are in mm, the kinematic viscosity is in mm^2/s, and the speed
// is in rpm.
inline double skf_starvation(double bore, double outside, double kinematic, double speed,
                             double replenishment = 3.0e-8, double slender = deep_slender)
{
  const double reach = (bore + outside) * std::sqrt(slender / (2.0 * (outside - bore)));
  return std::exp(-replenishment * kinematic * std::fabs(speed) * reach);
}

}    // namespace raceway
