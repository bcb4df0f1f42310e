// SPDX-License-Identifier: GPL-2.0-or-later
// Settings of a one-piece cage, as given in a deck.
#pragma once

#include "../geometry/cage_ring.h"
#include "ring_settings.h"

namespace bearing {

struct CageSettings {
  raceway::CageRing of;    // excluding the values that depend on the balls and the pitch circle
  raceway::RingProgram program;
  double play = -1.0, across = -1.0;    // m, total plays along the pitch circle and along the axis;
                                        // across -1: as along the circle
  bool planar = false;                  // neither tilts nor moves along the axis
  int shape = -1;                       // 0: cylinder; 1: sphere; -1: that which the guide needs
  double young[2] = {2.08e11, 2.08e11}, poisson[2] = {0.3, 0.3};    // for ball and cage; default:
                                                                    // steel
  double height = 0.0;                                              // height of the oil band in a
                                                                    // pocket, m
  double oil = 0.0, filled = 1.0;                                   // oil viscosity, Pa s; filled
                                                                    // fraction of the pockets
  double film_height = -1.0;    // height of the squeeze film, m; -1: that of the band
  double land_filled = -1.0;    // filled fraction at the land; -1: that of the pockets

  // Reads all words after the ball type and finishes the settings.
  void read(Arguments &);
  // Sets the values that follow from those above. Stops with an error if a value is missing or if
  // the values contradict each other.
  void finish(const Arguments &);
  void find_freedoms();    // sets those of `program` according to `planar`
  // Derives the values that depend on the radius of the balls (m) and of the pitch circle (m).
  // Stops with an error if the balls do not fit.
  void prepare(Arguments &, double ball_radius, double pitch);

 private:
  void read_guide(Arguments &);
};

}    // namespace bearing
