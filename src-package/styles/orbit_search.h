// SPDX-License-Identifier: GPL-2.0-or-later
// `settle orbit` of run_bearing: finds the steady state of a bearing under constant load and speed,
// in which every ball has its neighbour's state after a ball pass.
//
// The unknowns are the orbital speeds and spins of the balls by slot (orbit_balls.h), which decay
// over many ball passes, and the length of a ball pass. Everything else follows within a pass. Each
// ball pass is a value of the map, and FixedPoint (core/numbers/fixed_point.h) chooses the start of
// the next one.
#ifndef BEARING_ORBIT_SEARCH_H
#define BEARING_ORBIT_SEARCH_H

#include "../core/figures/settling.h"
#include "../core/numbers/fixed_point.h"
#include "bearing_compat.h"

#include <vector>

namespace bearing {

class OrbitBalls;

class OrbitSearch {
 public:
  enum { OFF, ON, FOUND, NONE };

  // It has doubles only, for restart files.
  struct State {
    double stage = OFF;
    double passes = 0.0;    // ball passes so far
    // Change of orbital speeds and spins in the last ball pass, relative and weighted by load, and
    // the estimated sum of all their further changes.
    double residual = HUGE_VAL, distance = HUGE_VAL;
    double best = HUGE_VAL, best_pass = 0.0;    // smallest residual; last useful ball pass
    double values = 0.0;     // successive values of the map up to the last ball pass
    double stretch = 1.0;    // next length of a ball pass over the last
    double jumps = 0.0;      // ball passes that began with chosen speeds
    double jumped = 0.0;     // 1: the present ball pass began with chosen speeds
  };

  State &now() { return now_; }
  const State &now() const { return now_; }
  bool runs() const { return now_.stage == ON; }
  bool found() const { return now_.stage == FOUND; }

  // Both act at the end of a step, `begin` before the first ball pass, `end_pass` after each one,
  // and set the speeds of the balls; collective. The orbit is found if figures change by at most a
  // fifth of `settled` from one ball pass to the next, and speeds and axes of the balls by at most
  // `settled` in all further ball passes together.
  void begin(LAMMPS_NS::LAMMPS *);
  void end_pass(LAMMPS_NS::LAMMPS *, const SettlingChanges &, double settled);

  // All numbers, for a restart file.
  std::vector<double> packed() const;
  void unpack(const std::vector<double> &);

 private:
  void judge(const OrbitBalls &, const std::vector<double> &end, const SettlingChanges &,
             double settled);

  State now_;
  std::vector<double> start_;    // numbers at the start of the present ball pass, by slot
  raceway::FixedPoint map_;
};

}    // namespace bearing

#endif
