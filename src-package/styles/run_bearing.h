// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(run_bearing,RunBearing)
// clang-format on
#else
#ifndef LMP_RUN_BEARING_H
#define LMP_RUN_BEARING_H

#include "../core/settings/deck_variable_table.h"
#include "bearing_compat.h"
#include "fix_bearing_run.h"
#include "run_phase.h"

namespace LAMMPS_NS {

// run_bearing settle N|auto|orbit passes P [step DT] [safety F] [rate HZ] [angle A] [settled S]
// [limit L]: chooses the step; settles for N ball passes, until little change remains, or until a
// ball pass ends in the state in which it began (orbit_search.h); and then measures for P ball
// passes with the fixes that wait for the measurement (run_phase.h).
class RunBearing : public bearing::CommandBase {
 public:
  explicit RunBearing(class LAMMPS *lmp) : bearing::CommandBase(lmp) {}
  void command(int, char **);

 private:
  struct Settings {
    double settle = 1.0, passes = 0.0;    // in ball passes
    bool automatic = false;               // settle until little change remains
    bool orbit = false;                   // settle on the orbit if there is one
    // remaining relative change below which the bearing counts as settled
    double settled = bearing::usual_number("settled");
    int limit = 100;                                // maximum number of ball passes while settling
    double step = bearing::usual_number("step");    // s; 0 to choose the step automatically
    double safety = bearing::usual_number("safety");    // fraction of the stability limit
    double rate = 0.0;     // Hz, sampling rate; 0 to use that of the records
    double angle = NAN;    // degrees, contact angle; NAN: computed from the
                           // positions of the balls
  };
  void read(class bearing::Arguments &);
  std::string words() const;
  void check_moved(const class bearing::Arguments &);
  bool implicit() const;
  void take_usual();
  void plan();
  void plan_samples();
  void plan_steps();
  void plan_history();
  void settle();
  void settle_adaptively();
  void warm_up();
  double steps_a_pass();
  void settle_until_still();
  void begin_at_step_0(double time);
  void plan_coarse();
  void plan_pass();
  void choose_steps();
  bool within_pass();
  bool still();
  bool rests_are_small();
  void say_pass();
  std::string pocket_fall();
  void say_cage_orbit();
  void note_settling(class FixBearingRecord &);
  bool automatic() const { return settings_.automatic; }
  std::string why_no_orbit();
  void begin_search();
  void shorten_ramps();
  void say_search();
  void say_multipliers();
  void note_orbit(class FixBearingRecord &);
  bearing::Sampling sampling();
  double sampled_length();
  void fix_step(double wanted);
  void measure();
  void start_fixes();
  void check_balance() const;
  void show(double rows, const std::string &title, const std::string &more = "");
  void run(double steps);
  void set_step(double dt);
  void execute(const std::string &line) { input->one(line.c_str()); }
  FixBearingRun::State &now() { return fix_->now(); }

  Settings settings_;
  FixBearingRun *fix_ = nullptr;
};

}    // namespace LAMMPS_NS

#endif
#endif
