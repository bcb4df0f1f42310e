// SPDX-License-Identifier: GPL-2.0-or-later
// Estimates the rest, i.e. the change that still remains while a bearing settles, from its mean
// values over ball passes. This file does not depend on the host.
//
// The method compares means over spans of 1, 2, 4 ... ball passes, up to a quarter of all ball
// passes. If the steps between means keep their direction, they are a drift: if the ratio of
// successive steps is r, a change of d r/(1 - r) remains after a step d. If the steps scatter about
// their mean, they are noise, and no rest remains. The result is at least the change per ball pass
// over the longest span or, if there is noise, the mean step per ball pass.
#ifndef BEARING_SETTLING_REST_H
#define BEARING_SETTLING_REST_H

#include "settling.h"

#include <vector>

namespace bearing {

// Largest ratio of two steps that are one ball pass apart. A mode that decays more slowly cannot be
// distinguished from a constant drift.
constexpr double slowest_decay = 0.98;

// Returns the rests of the torque, the loads and the cage speed (as relative changes) and of the
// spin axis (rad), and the changes between the last two of the longest spans for the pocket
// forces (their decrease) and for the orbit of the cage (as a fraction of half the play). They
// are infinite if there are fewer than two ball passes.
SettlingChanges settling_rest(const std::vector<SettlingSample> &passes,
                              double slowest = slowest_decay);

// Returns how far results wander in the last half of the ball passes: the largest difference
// between two means over `window` successive ball passes, relative to the last ball pass. They are
// not determined for the cage. A result that depends on a slow periodic motion wanders although it
// has settled. If the half is not longer than `window`, the means cover all but one of its ball
// passes. The values are infinite if there are fewer than four ball passes.
SettlingChanges settling_wander(const std::vector<SettlingSample> &passes, size_t window);

}    // namespace bearing

#endif
