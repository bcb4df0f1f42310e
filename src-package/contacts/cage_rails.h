// SPDX-License-Identifier: GPL-2.0-or-later
// The rails of one cage, and the cage balls of this rank that are held by them.
#pragma once

#include "../core/geometry/rail.h"
#include "../core/numbers/tag.h"

#include <vector>

namespace bearing {

struct CageRails {
  struct CageBall {
    int i, i_ring;    // local indices of the cage ball and of the ring that carries the rails
    tag_t tag, ring;
    int claim;            // index in RingSum; -1 if not yet claimed
    double loss = 0.0;    // W, power dissipated at the rails in the last step
  };
  std::vector<raceway::Rail> rails;
  std::vector<double> stiffness;    // N/m^1.5, one value per rail
  std::vector<CageBall> balls;      // sorted by tag
};

}    // namespace bearing
