// SPDX-License-Identifier: GPL-2.0-or-later
// Estimates the rest, i.e. the remaining change of a settling bearing, from the means of its ball
// passes. Independent of the host.
//
// Means over spans of 1, 2, 4 ... ball passes, up to a quarter of all ball passes, are compared.
// Steps between means that keep their direction are a drift: if the ratio of successive steps is r,
// a change of d r/(1 - r) remains after a step d. Steps that scatter about their mean are noise,
// which leaves no rest. A rest is at least the change per ball pass over the longest span; if there
// is noise, it is at least the mean step per ball pass.
#ifndef BEARING_SETTLING_REST_H
#define BEARING_SETTLING_REST_H

#include "settling.h"

#include <vector>

namespace bearing {

// Returns the rests of torque, loads and cage speed (relative) and of the spin axis (rad), and the
// decrease of pocket forces over the longest span. They are infinite if there are fewer than two
// ball passes.
SettlingChanges settling_rest(const std::vector<SettlingSample> &passes);

}    // namespace bearing

#endif
