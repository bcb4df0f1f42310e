// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/progress: prints a readable table of the progress of a run and the state of the
// bearings, with names, units, the finished fraction and the remaining time. The host's table
// allows only eight letters per column and does not show units.
#ifdef FIX_CLASS
FixStyle(bearing/progress,FixBearingProgress)
#else
#ifndef LMP_FIX_BEARING_PROGRESS_H
#define LMP_FIX_BEARING_PROGRESS_H

#include "../core/settings/driven_value.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {

class FixBearingProgress : public Fix {
 public:
  FixBearingProgress(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void post_run() override;

 private:
  double share() const;    // finished fraction of the run, 0 to 1
  void show();
  void say(const std::string &line) const;

  std::string title_, total_id_;
  bearing::DrivenValue share_;
  class ComputeBearingTotal *total_ = nullptr;
  double began_ = 0.0;    // s, wall-clock time at the start
  bigint shown_ = -1;     // step of the last row printed
  bool headed_ = false;
};

}    // namespace LAMMPS_NS

#endif
#endif
