// SPDX-License-Identifier: GPL-2.0-or-later
// The file of a shaft that bends, which `raceway shaft --reduced` writes (docs/shaft.rst).
#ifndef BEARING_BENDING_FILE_H
#define BEARING_BENDING_FILE_H

#include "../bodies/shaft_modes.h"
#include "arguments.h"

namespace bearing {

struct BendingShaft {
  double mass, centre;    // kg; m, along the bearing axis
  raceway::RingInertia inertia;
  raceway::ShaftModes modes;
};

// On all ranks alike; what is wrong ends the command with the file and the line.
BendingShaft read_bending_shaft(const Arguments &, const std::string &name);

}    // namespace bearing

#endif
