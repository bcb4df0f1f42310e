// SPDX-License-Identifier: GPL-2.0-or-later
// What a record has samples of: bearings and what they are made of, in the order of the file. No
// host here.
#ifndef BEARING_RECORD_LAYOUT_H
#define BEARING_RECORD_LAYOUT_H

#include "../contacts/bearing_columns.h"

#include <vector>

namespace bearing {

struct RecordLayout {
  struct Part {
    double tag;
    int bearing;    // from 0
  };
  struct Ring {
    double tag;
    int bearing;
    int raceway;    // 0 inner, 1 outer
    double origin[3];
  };
  struct Bearing {
    double of[of_kind::N];
  };

  // each bearing's parts side by side, by tag
  std::vector<Bearing> bearings;
  std::vector<Part> balls, cage;
  std::vector<Ring> rings;

  int grooves = 1;    // a ring and ball: contacts are by raceway, groove and ball

  size_t parts() const { return balls.size() + cage.size() + rings.size(); }
};

// What the owner of a ball says of it for the sums of its bearing.
struct BallShare {
  double contacts = 0.0, loaded[2] = {}, load[2] = {}, pressure[2] = {};    // inner, outer
  double h_min = HUGE_VAL, lambda = HUGE_VAL;
  double orbit = 0.0, friction_power = 0.0, damping_power = 0.0;
  double capacitance = 0.0;                               // both contacts in series
  double entrainment = 0.0, film[3] = {NAN, NAN, NAN};    // inner: h_min, lambda, h_c
  double rolling = 0.0, hysteresis = 0.0, spin = 0.0, drag = 0.0, cage = 0.0;    // W
  double asperity_share = NAN;                                                   // inner
  double capacitance_total = 0.0;    // with surroundings, both in series
  double cage_force = 0.0;           // N
};

}    // namespace bearing

#endif
