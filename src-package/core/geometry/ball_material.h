// SPDX-License-Identifier: GPL-2.0-or-later
// Materials of the balls. The rings are of bearing steel.
#pragma once

namespace raceway {

struct BallMaterial {
  double young, poisson;    // Pa
  double density;           // kg/m^3
  double expansion;         // 1/K
  double heat_capacity;     // J/(kg K)
  double conductivity;      // W/(m K)
};

// Gas-pressure sintered silicon nitride (Lily Bearing, "Ceramic materials and their properties");
// the heat capacity is from memory, unchecked.
constexpr BallMaterial silicon_nitride = {310e9, 0.24, 3270.0, 3.3e-6, 700.0, 29.0};

}    // namespace raceway
