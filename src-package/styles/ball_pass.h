// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the ball pass of a scene, i.e. the time in which the cage turns by one ball spacing.
#pragma once

#include "../core/settings/written.h"
#include "bearing_compat.h"

#include <string>
#include <vector>

namespace bearing {

// Returns the longest ball pass (s) of all bearings whose rings rotate. The balls are assumed to
// roll at the ring speeds that are currently imposed by the fixes bearing/ring. `angle` is the
// contact angle in degrees; if it is NAN, each bearing has its nominal angle or, if it has no name,
// the angle that follows from the current positions of its balls. Must be called on all ranks.
// Stops with an error that names `command` if there is no bearing, no imposed speed or no rotation.
double ball_pass_time(LAMMPS_NS::LAMMPS *, const std::string &command, double angle);

// A row of balls between an inner and an outer ring.
struct BallRow {
  double balls;    // number of balls
  double pass;     // s, duration of a ball pass, not finite if the balls do not move
};

// Returns all rows of balls. The arguments are those of ball_pass_time(). Must be called on all
// ranks.
std::vector<BallRow> ball_rows(LAMMPS_NS::LAMMPS *, const std::string &command, double angle);

}    // namespace bearing
