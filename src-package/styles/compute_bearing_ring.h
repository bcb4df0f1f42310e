// SPDX-License-Identifier: GPL-2.0-or-later
// compute bearing/ring: one row per ring of a group, with the motion of the ring, the total force
// and moment on it, and sums and extremes over its contacts. A group of inner rings yields one row
// per bearing.
#ifdef COMPUTE_CLASS
ComputeStyle(bearing/ring,ComputeBearingRing)
#else
#ifndef LMP_COMPUTE_BEARING_RING_H
#define LMP_COMPUTE_BEARING_RING_H

#include "../core/figures/bearing_figures.h"
#include "../core/figures/contact_reader.h"
#include "../deck/column_list.h"
#include "bearing_compat.h"

#include <vector>

namespace LAMMPS_NS {

class ComputeBearingRing : public Compute, public bearing::ColumnList {
 public:
  ComputeBearingRing(BRG_COMPUTE_ARGS);
  void init() override;
  void compute_local() override;
  double memory_usage() override;
  std::vector<Item> columns() const override;

 private:
  void tell();

  class PairBearingHertz *pair_;
  std::function<raceway::FilmCapacitorT<double>(const bearing::RacewayContact &)>
      capacitor_;    // or null
  struct Output {
    raceway::Column is;
    int motion;                       // index in of_ring::list, which is used if `figure` is null
    const bearing::Figure *figure;    // if not null, this result is evaluated over the contacts
  };
  std::vector<Output> columns_;
  std::vector<double> said_;    // values sent by the contacts of this rank
  std::vector<double> values_;
  std::vector<double *> rows_;
};

}    // namespace LAMMPS_NS

#endif
#endif
