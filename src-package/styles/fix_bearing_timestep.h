// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/timestep: compares the step of velocity Verlet with the stability limit set by
// contact stiffness and film damping, and adapts the step to the limit, prints a warning or stops
// the run.
#ifdef FIX_CLASS
FixStyle(bearing/timestep,FixBearingTimestep)
#else
#ifndef LMP_FIX_BEARING_TIMESTEP_H
#define LMP_FIX_BEARING_TIMESTEP_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingTimestep : public Fix {
 public:
  FixBearingTimestep(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  void write_restart(FILE *) override;
  void restart(char *) override;

 private:
  enum { ignore, warn, stop };
  void check();
  void set_step(double dt);

  PairBearingHertz *pair_ = nullptr;
  double safety_ = 0.3, largest_ = HUGE_VAL;
  bool adapt_ = false, warned_ = false;
  bool goes_on_ = false;    // true if the step and the previous check are from a restart file
  int exceed_ = warn;
  double limit_ = HUGE_VAL, smallest_limit_ = HUGE_VAL;
  double run_start_ = 0.0;    // s, wall-clock time
};

}    // namespace LAMMPS_NS

#endif
#endif
