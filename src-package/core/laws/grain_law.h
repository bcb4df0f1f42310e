// SPDX-License-Identifier: GPL-2.0-or-later
// Parameters of a contact between grains, which consists of a linear spring, a dashpot and friction
// (grain_contact.h).
#pragma once

#include <cmath>

namespace raceway {

struct GrainLaw {
  // Ratio of tangential to normal stiffness and damping. With this value, the tangential and normal
  // periods of a solid sphere are equal, because its effective mass at the surface is 2/7 of its
  // mass.
  static constexpr double tangential = 2.0 / 7.0;

  double stiffness = 0.0;      // N/m
  double restitution = 1.0;    // coefficient of restitution in a slow, frictionless collision
  double friction = 0.0;

  // Returns the dashpot constant for the reduced mass m (kg), N s/m.
  double damping(double m) const
  {
    const double a = std::log(restitution);
    return -2.0 * a * std::sqrt(m * stiffness / (M_PI * M_PI + a * a));
  }
  // Returns the duration of an undamped collision, s.
  double duration(double m) const { return M_PI * std::sqrt(m / stiffness); }
};

}    // namespace raceway
