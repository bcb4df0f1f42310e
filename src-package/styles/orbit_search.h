// SPDX-License-Identifier: GPL-2.0-or-later
// `settle orbit` of run_bearing: finds the steady state of a bearing under constant load and speed.
// In this state, every ball has, at the end of a ball pass, the state that its neighbour had at the
// start.
//
// The unknowns are the duration of a ball pass and, for each slot, the orbital speed and the spin
// of the ball (orbit_balls.h), whose deviations decay over many ball passes. All other quantities
// adapt within a ball pass. Each ball pass yields a value of the map, and FixedPoint
// (core/numbers/fixed_point.h) chooses the start of the next ball pass.
#pragma once

#include "../core/figures/settling.h"
#include "../core/numbers/fixed_point.h"
#include "bearing_compat.h"

#include <vector>

namespace bearing {

class OrbitBalls;

class OrbitSearch {
 public:
  enum { OFF, ON, FOUND, NONE };           // stage
  enum { DECK, FIRST_OF_DECK, COARSE };    // steps

  // Contains only doubles, so that it can be written to restart files.
  struct State {
    double stage = OFF;
    double passes = 0.0;    // number of ball passes so far
    // Relative change of orbital speeds and spins in the last ball pass, weighted by load, and the
    // estimated sum of all later changes.
    double residual = HUGE_VAL, distance = HUGE_VAL;
    double best = HUGE_VAL, best_pass = 0.0;    // smallest residual; last ball pass with progress
    double values = 0.0;     // number of successive values of the map up to the last ball pass
    double stretch = 1.0;    // duration of the next ball pass relative to the last
    double jumps = 0.0;      // number of ball passes that began with chosen speeds
    double jumped = 0.0;     // 1 if the current ball pass began with chosen speeds
    double steps = DECK;     // steps of the current ball pass: coarse, or those of the deck
    double apart = 0.0;      // relative difference between the speeds of the rows of balls
    double quiet = 0.0;      // number of successive ball passes with small changes
  };

  State &now() { return now_; }
  const State &now() const { return now_; }
  bool runs() const { return now_.stage == ON; }
  bool found() const { return now_.stage == FOUND; }
  bool coarse() const { return now_.steps == COARSE; }

  // Both functions are called at the end of a step and set the speeds of the balls: `begin` before
  // the first ball pass and `end_pass` after each ball pass. Both must be called on all ranks. The
  // orbit has been found if torque, loads and cage speed change by at most a fifth of `settled`
  // from one ball pass to the next, and the speeds and axes of the balls change by at most
  // `settled` in all further ball passes together.
  void begin(LAMMPS_NS::LAMMPS *);
  void end_pass(LAMMPS_NS::LAMMPS *, const SettlingChanges &, double settled);

  // Returns the Floquet multipliers of a ball pass as far as the search has encountered them,
  // starting with the largest.
  std::vector<raceway::Multiplier> multipliers() const { return map_.multipliers(); }

  // Names the values of a restart file.
  template <class List> void keep(List &list)
  {
    size_t n = start_.size();
    list(now_, n);
    start_.resize(n);
    list(start_);
    map_.keep(list);
  }

 private:
  // `noise` is the relative error of the speeds at the end of a ball pass. Ball passes in which
  // nothing is left of a disturbance repeat within 5e-9 to 3e-7 (docs/run_bearing.rst).
  static raceway::FixedPoint::Settings map_settings()
  {
    raceway::FixedPoint::Settings set;
    set.noise = 1e-6;
    return set;
  }
  bool repeats(const SettlingChanges &, double distance, double settled);
  void judge(const OrbitBalls &, const std::vector<double> &end, const SettlingChanges &,
             double settled);

  State now_;
  std::vector<double> start_;    // values at the start of the current ball pass, for each slot
  raceway::FixedPoint map_{map_settings(), {}};
};

}    // namespace bearing
