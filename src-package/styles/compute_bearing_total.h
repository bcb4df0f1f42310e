// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/total: global vector for thermo output, which contains the values of
// total_figures() in order.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/total,ComputeBearingTotal)
#else
#ifndef LMP_COMPUTE_BEARING_TOTAL_H
#define LMP_COMPUTE_BEARING_TOTAL_H

#include "../core/figures/bearing_figures.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {

class ComputeBearingTotal : public Compute {
 public:
  ComputeBearingTotal(BRG_COMPUTE_ARGS);
  void init() override;
  void compute_vector() override;
  const bearing::BearingFigures &figures() const { return figures_; }

 private:
  class PairBearingHertz *pair_;
  bearing::BearingFigures figures_;
  std::vector<double> values_ = std::vector<double>(bearing::total_figures().size());
};

}    // namespace LAMMPS_NS

#endif
#endif
