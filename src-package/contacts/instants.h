// SPDX-License-Identifier: GPL-2.0-or-later
// Raceway contacts between the steps of the host, as fix bearing/implicit knows them.
#ifndef BEARING_INSTANTS_H
#define BEARING_INSTANTS_H

#include "../physics/groove.h"
#include "bearing_compat.h"

namespace bearing {

// What is wanted: contacts at the shares k/number of a host's step, k = 1 to number - 1, for a
// lubricant of relative permittivity eps and films of at least `shortest` (m). number 0: nothing.
struct Instants {
  int number = 0;
  double eps = 1.0, shortest = 0.0;
};

struct InstantContact {
  int instant;    // k of number
  tag_t ball;
  raceway::Side side;
  double load, h_c, capacitance;    // N, m, F
};

}    // namespace bearing

#endif
