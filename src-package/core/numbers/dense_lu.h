// SPDX-License-Identifier: GPL-2.0-or-later
// Dense LU decomposition with row pivoting for a small number of unknowns. A matrix is factored
// once and used for many right-hand sides.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace raceway {

class DenseLU {
 public:
  void resize(int n)
  {
    n_ = n;
    a.assign(static_cast<size_t>(n) * n, 0.0);
    pivot_.assign(n, 0);
  }
  int size() const { return n_; }

  void factor()
  {
    for (int k = 0; k < n_; ++k) {
      int p = k;
      for (int i = k + 1; i < n_; ++i)
        if (std::fabs(row(i)[k]) > std::fabs(row(p)[k])) p = i;
      pivot_[k] = p;
      if (p != k) std::swap_ranges(row(k), row(k) + n_, row(p));
      const double *__restrict upper = row(k);
      for (int i = k + 1; i < n_; ++i) {
        double *__restrict to = row(i);
        const double f = to[k] /= upper[k];
        for (int j = k + 1; j < n_; ++j) to[j] -= f * upper[j];
      }
    }
  }

  void solve(double *y) const
  {
    for (int k = 0; k < n_; ++k) std::swap(y[k], y[pivot_[k]]);
    for (int i = 1; i < n_; ++i)
      for (int k = 0; k < i; ++k) y[i] -= row(i)[k] * y[k];
    for (int i = n_ - 1; i >= 0; --i) {
      for (int k = i + 1; k < n_; ++k) y[i] -= row(i)[k] * y[k];
      y[i] /= row(i)[i];
    }
  }

  std::vector<double> a;    // stored row by row

 private:
  double *row(int i) { return &a[static_cast<size_t>(i) * n_]; }
  const double *row(int i) const { return &a[static_cast<size_t>(i) * n_]; }
  int n_ = 0;
  std::vector<int> pivot_;
};

}    // namespace raceway
