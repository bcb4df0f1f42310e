// SPDX-License-Identifier: GPL-2.0-or-later
// Internal fix of run_bearing. It stores, in memory and in restart files, the progress of a run and
// the data that show whether the bearings have settled. It exists only while that command runs.
#ifdef FIX_CLASS
FixStyle(bearing/run,FixBearingRun)
#else
#ifndef LMP_FIX_BEARING_RUN_H
#define LMP_FIX_BEARING_RUN_H

#include "../core/figures/settling_rest.h"
#include "bearing_compat.h"
#include "orbit_search.h"
#include "run_phase.h"

#include <vector>

namespace LAMMPS_NS {

class FixBearingRun : public Fix {
 public:
  static constexpr const char *fixed_id = bearing::fix_of_run;

  // Contains only doubles, so that it can be written to restart files.
  struct State {
    double measures = 0.0;               // 1 if the bearings have settled
    double counted = 0.0;                // 1 if the number of ball passes to settle is given
    double step_length = 0.0;            // s; with adaptive steps, the step of the measurement
    double every = 1.0, within = 1.0;    // host steps per sample; samples per step
    double pass = 0.0;                   // s, duration of a ball pass
    double start = 0.0;                  // s, time at step 0
    double a_pass = 0.0;                 // number of samples per ball pass
    double begin = 0.0;                  // s, duration of the first part of settling, including the
                                         // load ramp
    double begin_steps = 0.0;            // number of steps in this part; 0 until adaptive steps
                                         // have ended
    double first_step = 0.0;             // step at which the first evaluated ball pass begins
    double passes = 0.0;                 // number of ball passes evaluated since then
    double steps = 0.0;                  // steps per ball pass, a multiple of `every`; 0 if unset
    double samples = 0.0;                // number of samples in the current ball pass
    double settled = 0.0;                // `settle orbit` ends when the changes are below this
                                         // value
    double evaluations = 0.0;            // number of force evaluations while settling
    double may_be_coarse = 0.0;          // 1 if the steps may be coarse while settling
    double coarse = 0.0;                 // 1 if the steps of the current ball pass are coarse
    bearing::SettlingSample sum;         // sum of the samples
    bearing::SettlingChanges changes;    // changes between the last two ball passes, for `settle
                                         // orbit`
    bearing::SettlingChanges rest;       // estimated remaining changes, if settling depends on them
  };

  FixBearingRun(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE *) override;
  void restart(char *) override;

  bool resumed() const { return resumed_; }
  // Returns the largest number of pockets of any one-piece cage, or 0 if there is no such cage.
  // This function may also be called before a run.
  double pockets() const;
  State &now() { return now_; }
  // Estimates the remaining changes from the ball passes that have been evaluated.
  void estimate_rest() { now_.rest = bearing::settling_rest(passes_); }
  // Returns how far means over `window` ball passes wander (settling_wander()).
  bearing::SettlingChanges wander(double window) const
  {
    return bearing::settling_wander(passes_, static_cast<size_t>(window));
  }
  bearing::OrbitSearch &orbit() { return orbit_; }

 private:
  std::string words_;    // words of the command that must not change when a run is continued
  State now_;
  bool resumed_ = false;
  bool has_pockets_ = false;
  std::vector<bearing::SettlingSample> passes_;    // mean values over each ball pass
  bearing::OrbitSearch orbit_;
  class PairBearingHertz *pair_ = nullptr;
  class ComputeBearingTotal *total_ = nullptr;

  bearing::SettlingSample sample();
  double cage_orbit();
  void end_pass();
  void search_orbit();
};

}    // namespace LAMMPS_NS

#endif
#endif
