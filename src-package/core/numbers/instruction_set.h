// SPDX-License-Identifier: GPL-2.0-or-later
// Selects between the two compilations of a large function on this processor (core/numbers/lane.h).
#ifndef RACEWAY_INSTRUCTION_SET_H
#define RACEWAY_INSTRUCTION_SET_H

namespace raceway {

// True if functions with RACEWAY_WIDE run on this processor. The environment variable
// RACEWAY_NARROW_LANES disables them, so that the independence of results can be checked.
bool wide_lanes();

}    // namespace raceway

#endif
