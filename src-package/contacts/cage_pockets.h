// SPDX-License-Identifier: GPL-2.0-or-later
// A one-piece cage, and the balls of this rank that are in its pockets.
#pragma once

#include "../core/geometry/cage_ring.h"
#include "../core/numbers/tag.h"

#include <vector>

namespace bearing {

struct CagePockets {
  struct Cell {
    int i, i_cage;    // local indices of a ball and of its cage
    tag_t ball, cage;
    int claim;    // index in RingSum; -1 if not yet claimed
  };
  struct Land {
    int i_cage, i_ring;    // local indices of a cage of this rank and of the ring that guides it
    tag_t cage, ring;
    int claim, ring_claim;
  };
  raceway::CageRing of;
  std::vector<Cell> cells;    // sorted by the tag of the ball
  std::vector<Land> lands;    // sorted by the tag of the cage
};

}    // namespace bearing
