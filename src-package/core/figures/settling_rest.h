// SPDX-License-Identifier: GPL-2.0-or-later
// The rest, that is, the remaining change of a settling bearing, estimated from the means of its
// ball passes. Independent of the host.
//
// Means over spans of 1, 2, 4 ... ball passes, up to a quarter of all ball passes, are compared.
// Steps between means that keep their direction are a drift: with the ratio r of successive steps,
// d r/(1 - r) remains after a step d. Steps that scatter about their mean are noise, which leaves
// no rest. A rest is at least the change per ball pass over the longest span; with noise, it is at
// least the mean step per ball pass.
#ifndef BEARING_SETTLING_REST_H
#define BEARING_SETTLING_REST_H

#include "settling.h"

#include <vector>

namespace bearing {

// Rests of torque, loads and cage speed (relative) and of the spin axis (rad), and the fall of
// pocket forces over the longest span. They are infinite with fewer than two ball passes.
SettlingChanges settling_rest(const std::vector<SettlingSample> &passes);

}    // namespace bearing

#endif
