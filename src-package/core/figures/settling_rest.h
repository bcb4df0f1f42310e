// SPDX-License-Identifier: GPL-2.0-or-later
// Estimates the rest, i.e. the change that still remains while a bearing settles, from its mean
// values over ball passes. This file does not depend on the host.
//
// The method compares means over spans of 1, 2, 4 ... ball passes, up to a quarter of all ball
// passes. If the steps between means keep their direction, they are a drift: if the ratio of
// successive steps is r, a change of d r/(1 - r) remains after a step d. If the steps scatter about
// their mean, they are noise, and no rest remains. The result is at least the change per ball pass
// over the longest span or, if there is noise, the mean step per ball pass.
#pragma once

#include "settling.h"

#include <vector>

namespace bearing {

// Returns the rests of the torque, the loads and the cage speed (as relative changes) and of the
// spin axis (rad), and the decrease in the pocket forces over the longest span. They are infinite
// if there are fewer than two ball passes.
SettlingChanges settling_rest(const std::vector<SettlingSample> &passes);

}    // namespace bearing
