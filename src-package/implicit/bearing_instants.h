// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts between two steps, for those who sample faster than the motion changes: places by the
// cubic through both ends of the internal step (cubic.h), velocities linear, and the contact
// formulas as anywhere else. Nothing of it feeds back.
#ifndef RACEWAY_BEARING_INSTANTS_H
#define RACEWAY_BEARING_INSTANTS_H

#include "bearing_bodies.h"

namespace raceway {

// A raceway contact between two steps; all 0 where there is none.
struct InstantLoad {
  double load, h_c, capacitance;    // N, m, F
};

// What is wanted: at shares k/number of the host's step, k = 1 to number - 1, for a lubricant of
// relative permittivity eps and films of at least `shortest` (m). number 0: nothing.
struct Instants {
  int number = 0;
  double eps = 1.0, shortest = 0.0;
};

class BearingInstants {
 public:
  explicit BearingInstants(const BearingBodies &b) : b_(b) {}

  void want(const Instants &);
  InstantLoad at(int k,
                 int groove) const;    // k from 1; groove of the model; of the last host step

  // Those that a step of h seconds passes, from share s0 to s1 of the host's, before it is
  // accepted.
  void pass(double h, double s0, double s1);

 private:
  struct alignas(32) Passed {    // a group between two steps
    LaneFrame frame;
    Vec3L v, w;
  };
  struct alignas(32) Look {
    Lane load, h_c, capacitance;
  };
  void look_at(double h, double s, Look *);

  const BearingBodies &b_;
  Instants instants_;
  int next_ = 1;
  std::vector<Passed> passed_;    // groups
  std::vector<Look> looks_;       // instant by instant, then contact by contact
};

}    // namespace raceway

#endif
