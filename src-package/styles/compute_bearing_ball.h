// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/ball: per-atom data of rolling balls, taken from their contacts with both
// raceways.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/ball,ComputeBearingBall)
#else
#ifndef LMP_COMPUTE_BEARING_BALL_H
#define LMP_COMPUTE_BEARING_BALL_H

#include "../core/figures/contact_reader.h"
#include "../deck/column_list.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {

class ComputeBearingBall : public Compute, public bearing::ColumnList {
 public:
  ComputeBearingBall(BRG_COMPUTE_ARGS);
  ~ComputeBearingBall() override;
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;
  std::vector<Item> columns() const override;

 private:
  struct Column {
    int own;                                    // index of a column that belongs to the ball
                                                // itself, or -1
    bool inner;                                 // true if the contact is with the inner raceway
    const bearing::ContactColumn *attribute;    // column of a contact, or null
  };
  double own_value(int own, const bearing::RacewayContact &) const;

  class PairBearingHertz *pair_;
  std::vector<Column> columns_;
  bearing::ContactSelection needed_;
  bearing::ContactContext context_;
  int nmax_ = 0;
  double *vector_ = nullptr, **array_ = nullptr;
};

}    // namespace LAMMPS_NS

#endif
#endif
