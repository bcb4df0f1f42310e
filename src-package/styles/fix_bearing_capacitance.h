// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/capacitance: electrical capacitance of every raceway contact, of every ball (series) and of
// the bearing (sum), sampled every N steps; nothing is computed in between.
#ifdef FIX_CLASS
FixStyle(bearing/capacitance,FixBearingCapacitance)
#else
#ifndef LMP_FIX_BEARING_CAPACITANCE_H
#define LMP_FIX_BEARING_CAPACITANCE_H

#include "contact_table.h"

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingCapacitance : public Fix {
 public:
  FixBearingCapacitance(class LAMMPS *, int, char **);
  ~FixBearingCapacitance() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  double memory_usage() override;

  double central_film(const bearing::RacewayContact &) const;    // m, h_c of eq 9, at least the shortest film
  double contact(const bearing::RacewayContact &) const;         // F, eq 8

 private:
  void sample();

  PairBearingHertz *pair_ = nullptr;
  double permittivity_ = 0.0, background_ = 0.0;
  double shortest_film_ = 1e-9;    // m; below it a capacitor of this model would be a short circuit
  double **per_ball_ = nullptr;    // inner, outer, series
  double total_ = 0.0, largest_ = 0.0, active_ = 0.0;
};

}    // namespace LAMMPS_NS

#endif
#endif
