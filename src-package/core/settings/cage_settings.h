// SPDX-License-Identifier: GPL-2.0-or-later
// A one-piece cage, as set in a deck.
#ifndef BEARING_CAGE_SETTINGS_H
#define BEARING_CAGE_SETTINGS_H

#include "../bodies/ring_program.h"
#include "../geometry/cage_ring.h"
#include "arguments.h"

namespace bearing {

struct CageSettings {
  raceway::CageRing of;    // without the values that depend on ball and pitch circle
  raceway::RingProgram program;
  double young[2] = {2.08e11, 2.08e11}, poisson[2] = {0.3, 0.3};    // ball and cage, steel
  double height = 0.0;                                              // m, band of oil in a pocket
  double oil = 0.0, filled = 1.0;                                   // Pa s; filled share of pockets
  double land_filled = -1.0;                                        // of land gap; -1: `filled`

  // Reads all words after the ball type. Error if words contradict each other.
  void read(Arguments &);
  // Derives the values that depend on the radius of the balls (m) and of the pitch circle (m).
  // Error if the balls do not fit.
  void prepare(Arguments &, double ball_radius, double pitch);

 private:
  void read_guide(Arguments &);
};

}    // namespace bearing

#endif
