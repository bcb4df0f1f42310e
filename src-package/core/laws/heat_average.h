// SPDX-License-Identifier: GPL-2.0-or-later
// Mean losses of a bearing whose loads or speeds vary with a period that is not known.
#pragma once

#include "heat_jumps.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raceway {

// Returns the weighted mean of the ball passes from `first` to before `last`. The weights fall to 0
// at both ends, as the fourth power of a sine, so that the part of an oscillation that is left over
// in the span hardly counts: of an oscillation with more than three periods in the span, less than
// 1/250 remains, of which plain means keep up to 1/11.
inline HeatPass mean_of_passes(const std::vector<HeatPass> &passes, size_t first, size_t last)
{
  const auto weight = [=](size_t k) {
    const double s = std::sin(3.14159265358979323846 * (k - first + 0.5) / (last - first));
    return s * s * s * s;
  };
  double sum = 0.0;
  for (size_t k = first; k < last; ++k) sum += weight(k);
  HeatPass mean;
  for (size_t k = first; k < last; ++k) mean.add(passes[k], weight(k) / sum);
  return mean;
}

// Returns the largest difference between the mean power in half of the passes and that in all of
// them, as a fraction. Wherever in its period an oscillation begins, it shows up in one of these
// differences: the halves differ, or both differ from the whole, whose middle counts most.
inline double scatter_of_passes(const std::vector<HeatPass> &passes)
{
  const size_t count = passes.size(), half = count / 2;
  const double mean = mean_of_passes(passes, 0, count).power();
  const double before = mean_of_passes(passes, 0, half).power() - mean;
  const double after = mean_of_passes(passes, half, count).power() - mean;
  return std::max(std::fabs(before), std::fabs(after)) / std::fabs(mean);
}

}    // namespace raceway
