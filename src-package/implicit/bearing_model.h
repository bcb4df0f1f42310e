// SPDX-License-Identifier: GPL-2.0-or-later
// One bearing as an implicit step sees it: who may touch whom, and the state of all of them. No
// host in it. Names have the bearing axis third; units are SI.
#ifndef RACEWAY_BEARING_MODEL_H
#define RACEWAY_BEARING_MODEL_H

#include "../physics/contact.h"
#include "../physics/rail.h"
#include "ring_program.h"

#include <vector>

namespace raceway {

struct BearingModel {
  struct Body {
    double mass, radius;
    bool spins;
  };    // rolling balls spin, cage balls do not
  struct Groove {
    int body, ring;
    const RacewayPhysics *physics;
  };    // a ball that may touch a raceway
  struct Pocket {
    int a, b;
    double K, reach, mass;
  };    // two bodies that may touch, as spheres
  struct Seat {
    int body, ring;
    const std::vector<Rail> *rails;
    const std::vector<double> *stiffness;
  };
  std::vector<Body> bodies;
  int rings = 0;
  std::vector<Groove> grooves;
  std::vector<Pocket> pockets;
  std::vector<Seat> seats;
  bool lubricated = false;
  Friction friction = Friction::none;    // all raceways; smoothed (creep > 0)
};

struct BodyPose {
  Vec3 x, v, w;
};

}    // namespace raceway

#endif
