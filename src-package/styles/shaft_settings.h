// SPDX-License-Identifier: GPL-2.0-or-later
// What a deck says of a shaft beyond what it says of a ring: its centre, and loads and unbalances
// at places along its axis.
#ifndef BEARING_SHAFT_SETTINGS_H
#define BEARING_SHAFT_SETTINGS_H

#include "ring_settings.h"

#include <vector>

namespace bearing {

struct ShaftSettings {
  struct Load {
    double at;               // m, along the bearing axis
    DrivenValue force[3];    // N, along the lab axes
  };
  struct Unbalance {
    double at;    // m
    raceway::Unbalance of;
  };
  bool centre_given = false;
  double centre = 0.0;    // m, of mass
  std::vector<Load> loads;
  std::vector<Unbalance> unbalances;

  // A keyword and its values; false: the next word is none of these.
  bool take(Arguments &);
  // The sums of the unbalances at a centre (m) and about it.
  void add_unbalances(double about, raceway::RingProgram &) const;
};

}    // namespace bearing

#endif
