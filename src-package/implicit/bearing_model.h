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
    bool spins;    // rolling balls spin, cage balls do not
  };
  struct Groove {    // a ball that may touch a raceway
    int body, ring;
    const RacewayPhysics *physics;
  };
  struct Pocket {    // two bodies that may touch, as spheres
    int a, b;
    double K, reach, mass;
  };
  struct Seat {    // a cage ball on the rails of a ring
    int body, ring;
    const std::vector<Rail> *rails;
    const std::vector<double> *stiffness;
  };
  std::vector<Body> bodies;
  int rings = 0;
  std::vector<Groove> grooves;
  std::vector<Pocket> pockets;
  std::vector<Seat> seats;
  unsigned parts = dry_parts;    // of the contact law of all raceways
};

struct BodyPose {
  Vec3 x, v, w;
};

}    // namespace raceway

#endif
