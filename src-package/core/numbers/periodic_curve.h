// SPDX-License-Identifier: GPL-2.0-or-later
// A smooth curve through values at equally spaced angles over one revolution. It is piecewise cubic
// and uses the slopes of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5, 1984). The curve does
// not overshoot, so a step in a table remains a step, whereas a spline would oscillate.
#pragma once

#include <cmath>
#include <vector>

namespace raceway {

struct CurveAt {
  double value = 0.0, slope = 0.0, bend = 0.0;    // value, first and second derivatives
};

class PeriodicCurve {
 public:
  // Value k applies at the angle first + k 2 pi/n.
  PeriodicCurve(double first, std::vector<double> values) :
      first_(first), step_(2.0 * M_PI / values.size()), y_(std::move(values)), rise_(y_.size())
  {
    const size_t n = y_.size();
    for (size_t k = 0; k < n; ++k) {
      const double before = y_[k] - y_[(k + n - 1) % n], after = y_[(k + 1) % n] - y_[k];
      rise_[k] = before * after > 0.0 ? 2.0 * before * after / (before + after) : 0.0;
    }
  }

  double spacing() const { return step_; }    // rad

  CurveAt at(double angle) const
  {
    const int n = static_cast<int>(y_.size());
    const double x = (angle - first_) / step_, whole = std::floor(x), s = x - whole;
    int k = static_cast<int>(std::fmod(whole, n));
    if (k < 0) k += n;
    const int next = k + 1 < n ? k + 1 : 0;
    const double chord = y_[next] - y_[k], c2 = 3.0 * chord - 2.0 * rise_[k] - rise_[next],
                 c3 = rise_[k] + rise_[next] - 2.0 * chord;
    return {y_[k] + s * (rise_[k] + s * (c2 + s * c3)),
            (rise_[k] + s * (2.0 * c2 + s * 3.0 * c3)) / step_,
            (2.0 * c2 + s * 6.0 * c3) / (step_ * step_)};
  }

 private:
  double first_, step_;
  std::vector<double> y_, rise_;    // values; slopes as changes per step
};

}    // namespace raceway
