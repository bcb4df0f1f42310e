// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/total: global vector for thermo output, contacts/bearing_columns.h in order.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/total,ComputeBearingTotal)
#else
#ifndef LMP_COMPUTE_BEARING_TOTAL_H
#define LMP_COMPUTE_BEARING_TOTAL_H

#include "../contacts/bearing_columns.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {

class ComputeBearingTotal : public Compute {
 public:
  ComputeBearingTotal(BRG_COMPUTE_ARGS);
  void init() override;
  void compute_vector() override;

 private:
  class PairBearingHertz *pair_;
  double values_[bearing::of_total::N] = {};
};

}    // namespace LAMMPS_NS

#endif
#endif
