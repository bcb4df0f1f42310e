// SPDX-License-Identifier: GPL-2.0-or-later
// The ball pass of a scene: the time in which the cage turns by the spacing of two balls.
#ifndef BEARING_BALL_PASS_H
#define BEARING_BALL_PASS_H

#include "../core/settings/written.h"
#include "bearing_compat.h"

#include <string>

namespace bearing {

// The longest ball pass (s) of all bearings whose rings rotate. Balls roll at the speeds that fixes
// bearing/ring impose at present. `angle` (degrees): contact angle; if NAN, the angle follows from
// the balls' present positions. Collective. Error naming `command` if there is no bearing, no
// imposed speed or no rotation.
double ball_pass_time(LAMMPS_NS::LAMMPS *, const std::string &command, double angle);

// Number of rows of balls, each between an inner and an outer ring. Collective.
size_t ball_rows(LAMMPS_NS::LAMMPS *, const std::string &command);

}    // namespace bearing

#endif
