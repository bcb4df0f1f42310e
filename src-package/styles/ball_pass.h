// SPDX-License-Identifier: GPL-2.0-or-later
// The ball pass of a scene: the time in which the cage turns by the distance of two balls.
#ifndef BEARING_BALL_PASS_H
#define BEARING_BALL_PASS_H

#include "bearing_compat.h"

#include <string>

namespace bearing {

// Value as the host writes that of a formula, so that a deck that passes it on has the same bits.
double written(double value);

// s; the longest of all bearings whose rings turn. Balls roll at the speeds that the fixes
// bearing/ring impose now. `angle` (degrees): contact angle; NAN: that of the balls' present
// places. Collective. Errors name `command`: no bearing, no imposed speed, no rotation.
double ball_pass_time(LAMMPS_NS::LAMMPS *, const std::string &command, double angle);

}    // namespace bearing

#endif
