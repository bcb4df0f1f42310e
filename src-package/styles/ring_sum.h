// SPDX-License-Identifier: GPL-2.0-or-later
// Adds what balls and cage exert on a ring, in an order that does not depend on the number of ranks.
//
// Only the owner of a ball computes its contacts, so a ring on another rank must be told. One rank adds
// in the order of the calls (sources in order, partner tags rising); several ranks gather all
// contributions, sort them into that same order and let the ring's owner add them: same bits.
#ifndef BEARING_RING_SUM_H
#define BEARING_RING_SUM_H

#include "../physics/vec3.h"
#include "bearing_compat.h"
#include "lammps.h"

#include <unordered_map>
#include <vector>

namespace bearing {

class RingSum : protected LAMMPS_NS::Pointers {
 public:
  enum Source { rail = 0, ball = 1 };    // in the order in which they are added
  explicit RingSum(LAMMPS_NS::LAMMPS *lmp) : Pointers(lmp), serial_(lmp->comm->nprocs == 1) {}

  void reset_rings();                                // after a neighbour build: forget all slots
  int slot(int i_ring, tag_t tag);                   // of a ring, owned or ghost
  void add(int slot, Source source, tag_t partner, const raceway::Vec3 &force, const raceway::Vec3 &torque)
  {
    if (serial_) {
      rings_[slot].force += force;
      rings_[slot].torque += torque;
    } else {
      keep(slot, source, partner, force, torque);
    }
  }
  void flush();                                      // into atom->f and atom->torque of owned rings

 private:
  void keep(int slot, Source source, tag_t partner, const raceway::Vec3 &force, const raceway::Vec3 &torque);

  bool serial_;
  struct Ring { int i; tag_t tag; raceway::Vec3 force, torque; };
  struct Part {
    tag_t ring, partner;
    int source;
    double force[3], torque[3];
    bool operator<(const Part &o) const
    {
      if (ring != o.ring) return ring < o.ring;
      if (source != o.source) return source < o.source;
      return partner < o.partner;
    }
  };
  std::vector<Ring> rings_;
  std::unordered_map<tag_t, int> slot_;
  std::vector<Part> parts_;    // more than one rank only
};

}    // namespace bearing

#endif
