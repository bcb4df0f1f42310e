// SPDX-License-Identifier: GPL-2.0-or-later
// Coordinates of the border of the linear system (step/bearing_system.h).
#pragma once

#include "ring_program.h"

#include <utility>
#include <vector>

namespace raceway {

// A free degree of freedom of a ring or shaft, or a mode of a flexible shaft.
struct Coordinate {
  const double *mass;    // kg; kg m^2 for a tilt or spin
  double *gained;        // m/s or rad/s, change of velocity since the base of the stage
  // Velocities at the start of the step, at the base of the stage, after the first stage, and at
  // present.
  const double *from, *base, *first, *now;
  bool tilts = false;
  bool of_cage = false;    // errors of this coordinate are treated like those of cage balls
  // Displacement per unit of the coordinate, 1 or m/rad. For a tilt it does not include the
  // displacement of the balls. For a spin it is 0, except for a cage, whose pockets move along the
  // pitch circle.
  double lever = 1.0;
  double spring = 0.0, damper = 0.0;    // stiffness and damping of a mode, N/m and N s/m
  const double *place = nullptr;        // m, current amplitude of a mode

  // Returns the displacement per unit of the coordinate, including the displacement of balls at the
  // distance `radius` (m) from the axis.
  double moves(double radius) const { return tilts ? radius + lever : lever; }
};

// A spring and damper that act on a weighted sum of coordinates.
struct Coupling {
  const Support *by;
  int after;    // position in the matrix, which is after the mass of this coordinate
  std::vector<std::pair<int, double>> of;
};

}    // namespace raceway
