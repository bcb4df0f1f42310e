// SPDX-License-Identifier: GPL-2.0-or-later
// Selects between the two compilations of a large function on this processor (core/numbers/lane.h).
#ifndef RACEWAY_INSTRUCTION_SET_H
#define RACEWAY_INSTRUCTION_SET_H

namespace raceway {

// True if functions with RACEWAY_WIDE run here. The environment variable RACEWAY_NARROW_LANES
// disables them, to check that results do not depend on it.
bool wide_lanes();

}    // namespace raceway

#endif
