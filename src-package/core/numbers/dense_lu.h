// SPDX-License-Identifier: GPL-2.0-or-later
// Dense LU decomposition with row pivoting for a small number of unknowns. A matrix is factored
// once and used for many right-hand sides.
#pragma once

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
        if (std::fabs(at(i, k)) > std::fabs(at(p, k))) p = i;
      pivot_[k] = p;
      for (int j = 0; p != k && j < n_; ++j) std::swap(at(k, j), at(p, j));
      for (int i = k + 1; i < n_; ++i) {
        const double f = at(i, k) /= at(k, k);
        for (int j = k + 1; j < n_; ++j) at(i, j) -= f * at(k, j);
      }
    }
  }

  void solve(double *y) const
  {
    for (int k = 0; k < n_; ++k) std::swap(y[k], y[pivot_[k]]);
    for (int i = 1; i < n_; ++i)
      for (int k = 0; k < i; ++k) y[i] -= at(i, k) * y[k];
    for (int i = n_ - 1; i >= 0; --i) {
      for (int k = i + 1; k < n_; ++k) y[i] -= at(i, k) * y[k];
      y[i] /= at(i, i);
    }
  }

  std::vector<double> a;    // stored row by row

 private:
  double &at(int i, int j) { return a[static_cast<size_t>(i) * n_ + j]; }
  double at(int i, int j) const { return a[static_cast<size_t>(i) * n_ + j]; }
  int n_ = 0;
  std::vector<int> pivot_;
};

}    // namespace raceway
