// SPDX-License-Identifier: GPL-2.0-or-later
// How the unknowns of the border move the rings that contacts meet: columns = T unknowns. A ring on
// a shaft that bends moves with the rigid shaft and with its modes. All others are unknowns.
#ifndef RACEWAY_SHAFT_LIFT_H
#define RACEWAY_SHAFT_LIFT_H

#include <vector>

namespace raceway {

class BearingBodies;

class ShaftLift {
 public:
  void find(const BearingBodies &);    // T at the present state
  // unknowns += T^T columns T, both square and row by row
  void add_matrix(const std::vector<double> &columns, std::vector<double> &unknowns);
  // unknowns += T^T columns
  void add_forces(const std::vector<double> &columns, std::vector<double> &unknowns) const;
  // columns = T unknowns
  void find_motions(const std::vector<double> &unknowns, std::vector<double> &columns) const;

 private:
  struct Entry {
    int column, unknown;
    double factor;
  };
  std::vector<Entry> entries_;
  const std::vector<std::vector<int>> *coupled_ = nullptr;    // columns that one column meets
  std::vector<double> half_;                                  // columns T
};

}    // namespace raceway

#endif
