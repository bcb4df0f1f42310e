// SPDX-License-Identifier: GPL-2.0-or-later
// The bearings in a record and their parts, in the order used in the file. This code does not
// depend on the host.
#pragma once

#include "../figures/bearing_columns.h"

#include <vector>

namespace bearing {

struct RecordLayout {
  struct RecordBody {
    double tag;
    int bearing;    // counted from 0
  };
  struct RecordRing {
    double tag;
    int bearing;
    int raceway;    // 0 inner, 1 outer, 2 one-piece cage
    double origin[3];
    // for a cage: play of the pockets along the pitch circle (m), value of CageRing::Guide, and
    // azimuth of the first pocket (rad)
    double play, guide, phase;
  };
  struct Bearing {
    double of[of_kind::N];
  };

  // the parts of each bearing are consecutive and sorted by tag
  std::vector<Bearing> bearings;
  std::vector<RecordBody> balls, cage;
  std::vector<RecordRing> rings;

  int grooves = 1;    // number of grooves per ring and ball; contacts are sorted by raceway, then
                      // groove, then ball

  static constexpr int cage_ring = 2;    // value of `raceway` for a one-piece cage
  bool pockets() const
  {
    for (const RecordRing &r : rings)
      if (r.raceway == cage_ring) return true;
    return false;
  }
  size_t bodies() const { return balls.size() + cage.size() + rings.size(); }
};

}    // namespace bearing
