// SPDX-License-Identifier: GPL-2.0-or-later
// Keeps the simulated time continuous from one run to the next and across restarts, for formulas
// that contain the host's keyword `time`. Some hosts do not store the time in restart files, and
// reset_timestep sets it to 0 in some hosts and makes it jump in others. At the end of a run the
// hosts round the time, so that it would depend in its last bit on where a run was split.
#pragma once

#include "bearing_compat.h"

#include <cmath>

namespace bearing {

class SimulatedTime {
 public:
  // Contents of a restart file. The time is `since` s at step `from` and increases by `step_length`
  // s per step.
  struct State {
    double since, from, step_length, step;    // `step`: the current step
    double now() const { return since + (step - from) * step_length; }
  };

  static State of(const LAMMPS_NS::Update &u)
  {
    return {u.atime, double(u.atimestep), u.dt, double(u.ntimestep)};
  }
  static double now(const LAMMPS_NS::Update &u) { return of(u).now(); }
  static void set(LAMMPS_NS::Update &u, double time)
  {
    u.atime = time;
    u.atimestep = u.ntimestep;
  }

  void run_done(const LAMMPS_NS::Update &u) { left_ = of(u), known_ = true; }
  void read(LAMMPS_NS::Update &u, const State &s)
  {
    left_ = s, known_ = true;
    set(u, s.now());
  }
  // Must be called before a run or before a restart file is written, so that a continued run is
  // bitwise identical to an uninterrupted run.
  void go_on(LAMMPS_NS::Update &u) const
  {
    if (!known_) return;
    if (u.dt == left_.step_length && u.ntimestep == LAMMPS_NS::bigint(left_.step)) {
      u.atime = left_.since;
      u.atimestep = LAMMPS_NS::bigint(left_.from);
    } else if (!goes_on(u)) {
      set(u, left_.now());
    }
  }
  bool goes_on(const LAMMPS_NS::Update &u) const
  {
    return known_ && std::fabs(now(u) - left_.now()) <= 1e-6 * u.dt;
  }

 private:
  State left_ = {};
  bool known_ = false;
};

}    // namespace bearing
