// SPDX-License-Identifier: GPL-2.0-or-later
// The data file of a flexible shaft, written by `raceway shaft --reduced` (docs/shaft.rst).
#pragma once

#include "../bodies/shaft_modes.h"
#include "arguments.h"

namespace bearing {

struct BendingShaft {
  double mass, centre;    // mass, kg; position of the centre of mass along the bearing axis, m
  raceway::RingInertia inertia;
  raceway::ShaftModes modes;
};

// Reads the file; the result is the same on all ranks. Error messages name the file and the line.
BendingShaft read_bending_shaft(const Arguments &, const std::string &name);

}    // namespace bearing
