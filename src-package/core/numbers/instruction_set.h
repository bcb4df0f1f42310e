// SPDX-License-Identifier: GPL-2.0-or-later
// Which of two compilations of a large function this processor runs (core/numbers/lane.h).
#ifndef RACEWAY_INSTRUCTION_SET_H
#define RACEWAY_INSTRUCTION_SET_H

namespace raceway {

// Whether functions with RACEWAY_WIDE run here. The environment variable RACEWAY_NARROW_LANES says
// that they must not: to see that results do not depend on it.
bool wide_lanes();

}    // namespace raceway

#endif
