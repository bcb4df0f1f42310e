// SPDX-License-Identifier: GPL-2.0-or-later
// The central data: one row per ball and raceway that may touch, filled once per step by the pair
// style. Forces, step control, capacitance and every output read it, so no contact is computed
// twice.
#ifndef BEARING_CONTACT_TABLE_H
#define BEARING_CONTACT_TABLE_H

#include "../numbers/tag.h"
#include "../raceway/profiled_contact.h"
#include "../raceway/raceway_physics.h"

#include <vector>

namespace bearing {

// A ball and a groove: a ring may have several grooves per ball (raceway->number).
struct RacewayContact {
  tag_t ball = 0, ring = 0;
  int i_ball = -1, i_ring = -1;    // local indices, valid until the next neighbour build
  int claim = -1;                  // in RingSum
  const raceway::RacewayPhysics *raceway = nullptr;
  const raceway::RacewayProfile *profile = nullptr;      // null: the raceway is a torus
  const raceway::BallProfile *ball_profile = nullptr;    // null: the ball is a sphere
  double *kept = nullptr;                                // state variables of the law
  bool live = false;                                     // surfaces overlap
  raceway::ContactState state;    // at this step; if not live, only the frame is set
  // Speed of the ball about the ring, rad/s, if the pair style evaluates gaps. Without contact the
  // state then has frame, overlap and entrainment speed.
  double orbit = 0.0;

  bool flawed() const { return profile || ball_profile; }
  raceway::Side side() const { return raceway->groove.side; }
  int groove() const { return raceway->number; }
};

// Two spheres in frictionless contact: ball and cage ball, or ball and ball without a cage.
struct SphereContact {
  tag_t tag_i = 0, tag_j = 0;    // tag_i < tag_j
  int i = -1, j = -1;
  double K = 0.0;                                        // N/m^1.5
  double reach = 0.0;                                    // m, sum of the radii
  double mass = 0.0;                                     // kg, reduced
  double stiffness = 0.0, damping = 0.0, force = 0.0;    // at this step: N/m, N s/m, N
  double loss = 0.0;                                     // W, to damping
};

// A ball in its pocket of a one-piece cage.
struct PocketRow {
  tag_t ball = 0, cage = 0;
  double mass = 0.0;                                     // kg, reduced
  double stiffness = 0.0, damping = 0.0, force = 0.0;    // at this step: N/m, N s/m, N
  double loss = 0.0;                                     // W, in wall, friction and oil
};

struct ContactTable {
  std::vector<RacewayContact> raceway;    // by ball tag, ring tag, groove
  std::vector<SphereContact> sphere;      // by smaller tag, then larger
  std::vector<PocketRow> pocket;          // of the balls of this rank, by cage fix, then ball

  int live() const
  {
    int n = 0;
    for (const RacewayContact &c : raceway) n += c.live;
    return n;
  }

  // True for the row that represents its ball and ring if a single value is needed: of the
  // consecutive rows of one ball and ring, one per groove, the row with the largest load.
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

#endif
