// SPDX-License-Identifier: GPL-2.0-or-later
// What a record has samples of: bearings and what they are made of, in the order of the file. No
// host here.
#ifndef BEARING_RECORD_LAYOUT_H
#define BEARING_RECORD_LAYOUT_H

#include "../figures/bearing_columns.h"

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

}    // namespace bearing

#endif
