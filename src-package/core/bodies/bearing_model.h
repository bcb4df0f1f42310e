// SPDX-License-Identifier: GPL-2.0-or-later
// Model of one bearing: pairs of bodies that may touch, the program of each ring, and the state.
// The model does not depend on the host: atoms are identified by tags, and the mover of a ring is
// an index into a list of the caller. All other indices refer to bodies and rings. The bearing axis
// is the third axis, and units are SI.
#pragma once

#include "../geometry/cage_ring.h"
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
    bool spins;    // true for rolling balls, false for cage balls
  };
  struct Ring {
    Tag tag;
    int mover;                     // index in the caller's list, -1: at rest except for a constant
                                   // spin
    std::vector<RingValue> own;    // values set only for this ring
    bool on_shaft = false;         // moves as one body with all other rings of the same mover
    double at = 0.0;               // m, position along that shaft relative to its centre
    Tag held_by = 0;               // tag of the ring to which the supports connect this ring; 0:
                                   // ground
    int holder = -1;               // held_by as an index into rings
  };
  struct Shaft {    // rings that move as one body
    int mover;
    std::vector<int> rings;               // sorted by tag
    const ShaftModes *modes = nullptr;    // only for a flexible shaft
  };
  struct Groove {    // a ball and a raceway that it may touch
    int body, ring;
    const RacewayPhysics *physics;
    const RacewayProfile *profile = nullptr;    // null: the raceway is a torus
    const BallProfile *ball = nullptr;          // null: the ball is a sphere
  };
  struct Pocket {    // two bodies that may touch, both treated as spheres
    int a, b;
    double K, reach, mass;
  };
  struct Seat {    // a cage ball on the rails of a ring
    int body, ring;
    const std::vector<Rail> *rails;
    const std::vector<double> *stiffness;
  };
  struct Cage {        // a one-piece cage
    int ring, land;    // land: ring that guides the cage; -1: none
    const CageRing *of;
    std::vector<int> balls;    // bodies, sorted by tag
  };
  std::vector<Body> bodies;       // rolling balls first, then cage balls, both sorted by tag
  std::vector<Ring> rings;        // sorted by tag
  std::vector<Shaft> shafts;      // sorted by first ring
  std::vector<Groove> grooves;    // sorted by body, then ring
  std::vector<Pocket> pockets;    // sorted by smaller tag, then larger tag
  std::vector<Seat> seats;        // sorted by cage, then body
  std::vector<Cage> cages;        // sorted by ring
  unsigned parts = 0;             // parts of the contact law, common to all raceways

  Tag name() const { return rings.front().tag; }
};

struct BodyPose {
  Vec3 x, v, w;
  Quaternion turn;    // rotation from the ball's body-fixed axes, where needed
};

}    // namespace raceway
