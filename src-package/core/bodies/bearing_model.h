// SPDX-License-Identifier: GPL-2.0-or-later
// One bearing: who may touch whom, what each ring is told to do, and the state of all of them. No
// host in it: atoms have tags, and what moves a ring is a number in a list of the caller. Indices
// point into bodies and rings. Names have the bearing axis third; units are SI.
#ifndef RACEWAY_BEARING_MODEL_H
#define RACEWAY_BEARING_MODEL_H

#include "../geometry/rail.h"
#include "../raceway/profiled_contact.h"
#include "../raceway/raceway_physics.h"
#include "ring_program.h"

#include <cstdint>
#include <vector>

namespace raceway {

struct ShaftModes;

struct BearingModel {
  using Tag = std::int64_t;
  struct Body {
    Tag tag;
    double mass, radius;
    bool spins;    // rolling balls spin, cage balls do not
  };
  struct Ring {
    Tag tag;
    int mover;                     // in the caller's list, -1: at rest
    std::vector<RingValue> own;    // what this ring has for itself
    bool on_shaft = false;         // moves as one body with all rings of its mover
    double at = 0.0;               // m, along that shaft from its centre
    Tag held_by = 0;               // ring that its supports hold it to, 0: the ground
    int holder = -1;               // the same, in rings
  };
  struct Shaft {    // rings that move as one body
    int mover;
    std::vector<int> rings;               // by tag
    const ShaftModes *modes = nullptr;    // of a shaft that bends
  };
  struct Groove {    // a ball that may touch a raceway
    int body, ring;
    const RacewayPhysics *physics;
    const RacewayProfile *profile = nullptr;    // where it is not a torus
    const BallProfile *ball = nullptr;          // where that is not a sphere
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
  std::vector<Body> bodies;       // rolling balls first, then cage balls, each by tag
  std::vector<Ring> rings;        // by tag
  std::vector<Shaft> shafts;      // by first ring
  std::vector<Groove> grooves;    // by body, then ring
  std::vector<Pocket> pockets;    // by smaller tag, then larger
  std::vector<Seat> seats;        // by cage, then body
  unsigned parts = 0;             // of the contact law of all raceways

  Tag name() const { return rings.front().tag; }
};

struct BodyPose {
  Vec3 x, v, w;
  Quaternion turn;    // from the own axes of a ball, where that matters
};

}    // namespace raceway

#endif
