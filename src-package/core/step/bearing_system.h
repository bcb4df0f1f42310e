// SPDX-License-Identifier: GPL-2.0-or-later
// The linear system of one Newton correction:
//   A_k x_k + B_k y + sum_i s_ik n_i l_i = r_k        x_k: correction of a body
//   sum_k C_k x_k + D y                  = r_y        y: corrections of rings and shafts
//   l_i/a_i = n_i . (x_first - x_second)              closed cage contacts
// where s_ik is +1 for the first and -1 for the second body of link i. Blocks are eliminated first,
// then links; the system is then solved for y and back-substituted, in a time proportional to the
// number of balls. factor() stores the data for solve(), so each later correction with the same
// derivatives requires only one more right-hand side to be solved.
//
// Contacts contribute to columns B and rows C for the motions of rings. These motions are the
// unknowns y themselves, except for rings on flexible shafts: such a ring has separate columns, and
// its motions follow from y through T (shaft_lift.h). The modes of a shaft therefore do not add any
// cost per body.
#pragma once

#include "../bodies/bearing_bodies.h"
#include "../bodies/link_chain.h"
#include "../bodies/shaft_lift.h"
#include "../numbers/dense_lu.h"

namespace raceway {

class BearingSystem {
 public:
  explicit BearingSystem(BearingBodies &b) : b_(b)
  {
    chain_.resize(static_cast<int>(b.body_at.size()));
  }

  // Sets the residual to M (V_base - V) + h times the forces due to the rotating frame. With
  // `fresh` it also sets the blocks to the masses and everything else to 0.
  void start(double h, bool fresh);
  // Adds the right-hand sides of the border and, with `fresh`, the part of D that does not depend
  // on contacts, at the fraction s of the step. Positions change with velocities for `follows`
  // seconds.
  void add_border(double h, double follows, double s, bool fresh);
  // Saves the residuals and, with `fresh`, the part of the matrix that is due to raceways and
  // inertia, without the contributions of cages and supports.
  void keep(bool fresh);
  // Restores the residuals and the matrix. The residuals are updated to first order for the
  // corrections made since keep().
  void restore();
  void add_kept();    // adds the kept right-hand sides of the border; called after add_border()
  void factor();
  void solve();    // afterwards the corrections are in BodyGroup::rhs and y()
  void halve()     // halves the corrections of the border
  {
    for (double &one : y_) one *= 0.5;
    for (double &one : motions_apart_) one *= 0.5;
  }

  struct alignas(32) Column {
    Lane a[6];
  };
  int columns() const { return b_.columns; }
  Lane *B(int group, int column) { return B_[group * columns() + column].a; }
  Lane *C(int group, int column) { return C_[group * columns() + column].a; }
  double &D(int row, int column) { return corner_[row * columns() + column]; }
  double y(size_t coordinate) const { return y_[coordinate]; }
  double motion(int column) const { return motions_[column]; }
  LinkChain &links() { return chain_; }

 private:
  void resize();
  void clear(bool only_cages);
  void add_coupling(const Coupling &, double h, double follows);
  void add_spins(double h, bool fresh);
  void factor_groups();
  void condense_groups();
  template <class ColumnOf> void condense_links(ColumnOf column, bool mark);

  BearingBodies &b_;
  std::vector<Column> B_, C_;    // ordered by group, then by column
  DenseLU border_;
  std::vector<double> y_, forces_;    // corrections of the border, forces of the links
  // Matrix and motions of the columns. They are those of the border, unless there are flexible
  // shafts.
  double *corner_ = nullptr, *motions_ = nullptr;
  std::vector<double> corner_apart_, motions_apart_;
  ShaftLift lift_;
  LinkChain chain_;
  struct alignas(32) KeptGroup {
    Lane A[36], rhs[6];
    bool coupled;
  };
  struct {
    std::vector<KeptGroup> groups;
    std::vector<Column> B;
    std::vector<double> corner, y;
    std::vector<Vec3L> pushes;    // force and moment on each ring
  } kept_;
};

}    // namespace raceway
