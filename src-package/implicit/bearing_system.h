// SPDX-License-Identifier: GPL-2.0-or-later
// The linear system of one Newton correction:
//   A_k x_k + B_k y + sum_i s_ik n_i l_i = r_k        x_k of a body
//   sum_k C_k x_k + D y                  = r_y        y of the free degrees of freedom of the rings
//   l_i/a_i = n_i . (x_first - x_second)              closed cage contacts
// with s_ik = +1 for the first and -1 for the second body of link i. It is solved block by block,
// link by link, then y, and back: a time proportional to the number of balls. factor() keeps what
// solve() needs, so that later corrections with the same derivatives cost one right-hand side.
#ifndef RACEWAY_BEARING_SYSTEM_H
#define RACEWAY_BEARING_SYSTEM_H

#include "bearing_bodies.h"
#include "dense_lu.h"
#include "link_chain.h"

namespace raceway {

class BearingSystem {
 public:
  explicit BearingSystem(BearingBodies &b) : b_(b)
  {
    chain_.resize(static_cast<int>(b.body_at.size()));
  }

  // What is still missing of M (V_base - V) + h frame; `fresh`: masses into the blocks, all else 0.
  void start(double h, bool fresh);
  // The rings' right-hand sides and the part of D that no contact brings, at share s of the step.
  // Positions follow velocities over `follows` seconds.
  void add_rings(double h, double follows, double s);
  void factor();
  void solve();    // corrections: BodyGroup::rhs and y()

  struct alignas(32) Column {
    Lane a[6];
  };
  int unknowns() const { return static_cast<int>(b_.free.size()); }
  Lane *B(int group, int unknown) { return B_[group * unknowns() + unknown].a; }
  Lane *C(int group, int unknown) { return C_[group * unknowns() + unknown].a; }
  double &D(int row, int column) { return border_.a[row * unknowns() + column]; }
  double y(int unknown) const { return y_[unknown]; }
  LinkChain &links() { return chain_; }

 private:
  void resize();
  void factor_groups();
  template <class ColumnOf> void condense_links(ColumnOf column, bool mark);

  BearingBodies &b_;
  std::vector<Column> B_, C_;    // group by group, unknown by unknown
  DenseLU border_;
  std::vector<double> y_, forces_;    // border, links
  LinkChain chain_;
};

}    // namespace raceway

#endif
