// SPDX-License-Identifier: GPL-2.0-or-later
// What a deck says of a shaft beyond what it says of a ring: its centre, and loads and unbalances
// at places along its axis.
#ifndef BEARING_SHAFT_SETTINGS_H
#define BEARING_SHAFT_SETTINGS_H

#include "bending_file.h"
#include "ring_settings.h"

#include <memory>
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
  std::string file;    // of a shaft that bends, else empty
  std::shared_ptr<const BendingShaft> of_file;

  // A keyword and its values; false: the next word is none of these.
  bool take(Arguments &);
  // The sums of the unbalances at a centre (m) and about it.
  void add_unbalances(double about, raceway::RingProgram &) const;
  // What they are for each mode of a shaft that bends.
  std::vector<raceway::Unbalance> unbalances_of_modes() const;
  // Reads the file, which gives mass, inertia and centre.
  void read_file(const Arguments &, raceway::RingProgram &);
};

}    // namespace bearing

#endif
