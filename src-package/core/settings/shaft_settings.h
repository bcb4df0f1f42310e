// SPDX-License-Identifier: GPL-2.0-or-later
// Settings that a shaft has in addition to those of a ring: the position of its centre, and loads
// and unbalances that act at positions along its axis.
#pragma once

#include "bending_file.h"
#include "ring_settings.h"

#include <memory>
#include <vector>

namespace bearing {

struct ShaftSettings {
  struct Load {
    double at;               // m, along the bearing axis
    DrivenValue force[3];    // N, along the axes of the lab frame
  };
  struct Unbalance {
    double at;    // m
    raceway::Unbalance of;
  };
  bool centre_given = false;
  double centre = 0.0;    // m, centre of mass
  std::vector<Load> loads;
  std::vector<Unbalance> unbalances;
  std::string file;    // file of a flexible shaft, or empty
  std::shared_ptr<const BendingShaft> of_file;

  // Reads a keyword and its values. Returns false if the next word is not such a keyword.
  bool take(Arguments &);
  // Adds the unbalances and their first moments about the centre at `about` (m).
  void add_unbalances(double about, raceway::RingProgram &) const;
  // Returns the unbalances that act on each mode of a flexible shaft.
  std::vector<raceway::Unbalance> unbalances_of_modes() const;
  // Reads the file and takes the mass, the inertia and the centre from it.
  void read_file(const Arguments &, raceway::RingProgram &);
};

}    // namespace bearing
