// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/total: global vector for thermo output.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/total,ComputeBearingTotal)
#else
#ifndef LMP_COMPUTE_BEARING_TOTAL_H
#define LMP_COMPUTE_BEARING_TOTAL_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

class ComputeBearingTotal : public Compute {
 public:
  ComputeBearingTotal(BRG_COMPUTE_ARGS);
  void init() override;
  void compute_vector() override;

  enum Column {    // c_ID[...], from 1
    LIVE,
    LOADED_BALLS,
    INNER_LOAD,
    OUTER_LOAD,
    PRESSURE,
    H_MIN,
    LAMBDA,
    ORBIT,
    FRICTION_POWER,
    DAMPING_POWER,
    CAGE_FORCE,
    N_COLUMN
  };

 private:
  class PairBearingHertz *pair_;
  double values_[N_COLUMN] = {};
};

}    // namespace LAMMPS_NS

#endif
#endif
