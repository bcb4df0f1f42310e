// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the connected components of n elements (union-find).
#pragma once

#include <vector>

namespace bearing {

class UnionFind {
 public:
  explicit UnionFind(int n = 0)
  {
    while (size() < n) add();
  }
  int size() const { return static_cast<int>(parent_.size()); }
  int add()
  {
    parent_.push_back(size());
    return size() - 1;
  }
  int find(int i)
  {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int i, int j) { parent_[find(i)] = find(j); }

 private:
  std::vector<int> parent_;
};

}    // namespace bearing
