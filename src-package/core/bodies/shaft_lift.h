// SPDX-License-Identifier: GPL-2.0-or-later
// The map T from the unknowns of the border to the motions of rings at contacts: columns = T
// unknowns. A ring on a flexible shaft moves with the rigid shaft and with the shaft's modes. For
// all other rings T is the identity.
#pragma once

#include <vector>

namespace raceway {

class BearingBodies;

class ShaftLift {
 public:
  void find(const BearingBodies &);    // computes T in the current state
  // unknowns += T^T columns T; both matrices are square and stored row by row
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
  const std::vector<std::vector<int>> *coupled_ = nullptr;    // columns coupled to each column
  std::vector<double> half_;                                  // columns T
};

}    // namespace raceway
