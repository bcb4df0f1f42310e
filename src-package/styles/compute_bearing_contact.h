// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/contact: local data with one row per active raceway contact, which contains the
// requested columns.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/contact,ComputeBearingContact)
#else
#ifndef LMP_COMPUTE_BEARING_CONTACT_H
#define LMP_COMPUTE_BEARING_CONTACT_H

#include "../core/figures/contact_reader.h"
#include "../deck/column_list.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {

class ComputeBearingContact : public Compute, public bearing::ColumnList {
 public:
  ComputeBearingContact(BRG_COMPUTE_ARGS);
  void init() override;
  void compute_local() override;
  double memory_usage() override;
  std::vector<Item> columns() const override;

 private:
  class PairBearingHertz *pair_;
  bearing::ContactSelection columns_;
  bearing::ContactContext context_;
  std::vector<double> values_;
  std::vector<double *> rows_;
};

}    // namespace LAMMPS_NS

#endif
#endif
