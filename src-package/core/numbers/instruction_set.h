// SPDX-License-Identifier: GPL-2.0-or-later
// Selects which of the two compiled versions of a large function to call on the current processor
// (core/numbers/lane.h).
#pragma once

namespace raceway {

// Returns true if functions with RACEWAY_WIDE run on this processor. The environment variable
// RACEWAY_NARROW_LANES disables them, so that one can check that results do not depend on the
// choice.
bool wide_lanes();

}    // namespace raceway
