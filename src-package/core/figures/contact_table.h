// SPDX-License-Identifier: GPL-2.0-or-later
// The central table, with one row for each pair of a ball and a raceway that may touch. The pair
// style fills it once per step. Forces, step control, capacitance and all output are computed from
// it, so no contact is computed twice.
#pragma once

#include "../numbers/tag.h"
#include "../raceway/profiled_contact.h"
#include "../raceway/raceway_physics.h"

#include <vector>

namespace bearing {

// A ball and a groove that may touch. A ring may have several grooves per ball (raceway->number).
struct RacewayContact {
  tag_t ball = 0, ring = 0;
  int i_ball = -1, i_ring = -1;    // local indices, valid until the next neighbour build
  int claim = -1;                  // index in RingSum
  const raceway::RacewayPhysics *raceway = nullptr;
  const raceway::RacewayProfile *profile = nullptr;      // null if the raceway is a torus
  const raceway::BallProfile *ball_profile = nullptr;    // null if the ball is a sphere
  double *kept = nullptr;                                // state variables of the law
  bool live = false;                                     // whether the surfaces overlap
  raceway::ContactState state;    // state at this step; if not live, only the frame is set
  // Speed (rad/s) of the ball about the ring, if the pair style evaluates gaps. If there is no
  // contact, the state then consists of the frame, the overlap and the entrainment speed.
  double orbit = 0.0;

  bool flawed() const { return profile || ball_profile; }
  raceway::Side side() const { return raceway->groove.side; }
  int groove() const { return raceway->number; }
};

// Two spheres in frictionless contact, either a ball and a cage ball, or two balls of a bearing
// without a cage.
struct SphereContact {
  tag_t tag_i = 0, tag_j = 0;    // tag_i < tag_j
  int i = -1, j = -1;
  double K = 0.0;                                        // N/m^1.5
  double reach = 0.0;                                    // m, sum of the radii
  double mass = 0.0;                                     // kg, reduced mass
  double stiffness = 0.0, damping = 0.0, force = 0.0;    // at this step, in N/m, N s/m and N
  double loss = 0.0;                                     // W, dissipated by damping
};

// A ball in its pocket of a one-piece cage.
struct PocketRow {
  tag_t ball = 0, cage = 0;
  double mass = 0.0;                                     // kg, reduced mass
  double stiffness = 0.0, damping = 0.0, force = 0.0;    // at this step, in N/m, N s/m and N
  double loss = 0.0;                                     // W, dissipated in the wall, by friction
                                                         // and in the oil
};

struct ContactTable {
  std::vector<RacewayContact> raceway;    // sorted by ball tag, ring tag and groove
  std::vector<SphereContact> sphere;      // sorted by smaller tag, then by larger tag
  std::vector<PocketRow> pocket;          // balls of this rank, sorted by cage fix, then by ball

  int live() const
  {
    int n = 0;
    for (const RacewayContact &c : raceway) n += c.live;
    return n;
  }

  // Returns true for the row that represents its ball and ring if a single value is needed. Among
  // the consecutive rows for a ball and a ring (one per groove), this is the row with the largest
  // load.
  bool leads(const RacewayContact &c) const
  {
    const RacewayContact *const first = raceway.data(), *const end = first + raceway.size();
    const auto beside = [&c](const RacewayContact &o) {
      return o.ball == c.ball && o.ring == c.ring;
    };
    const auto load = [](const RacewayContact &o) { return o.live ? o.state.load : -1.0; };
    for (const RacewayContact *o = &c; o != first && beside(o[-1]); --o)
      if (load(o[-1]) >= load(c)) return false;
    for (const RacewayContact *o = &c + 1; o != end && beside(*o); ++o)
      if (load(*o) > load(c)) return false;
    return true;
  }
};

}    // namespace bearing
