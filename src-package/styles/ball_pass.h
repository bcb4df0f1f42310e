// SPDX-License-Identifier: GPL-2.0-or-later
// The ball pass of a scene: the time in which the cage turns by the spacing of two balls.
#ifndef BEARING_BALL_PASS_H
#define BEARING_BALL_PASS_H

#include "../core/settings/written.h"
#include "bearing_compat.h"

#include <string>

namespace bearing {

// The longest ball pass (s) of all bearings whose rings rotate. Balls roll at the speeds that the
// fixes bearing/ring impose now. `angle` (degrees): contact angle; NAN: the angle at the balls'
// present positions. Collective. Errors name `command`: no bearing, no imposed speed, no rotation.
double ball_pass_time(LAMMPS_NS::LAMMPS *, const std::string &command, double angle);

// Number of rows of balls, each between an inner and an outer ring. Collective.
size_t ball_rows(LAMMPS_NS::LAMMPS *, const std::string &command);

}    // namespace bearing

#endif
