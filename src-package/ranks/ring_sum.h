// SPDX-License-Identifier: GPL-2.0-or-later
// Sums the forces and torques of balls and cage on a ring in an order that does not depend on the
// number of ranks.
//
// Only the owner of a ball computes the ball's contacts, so their forces must be sent if the ring
// is on another rank. After a neighbour build, every contact claims a term in the sum over its
// ring. A rank sends its claims on the rings of another rank once, and then only six numbers per
// claim in each step. The owner of the ring adds the terms in the order of their sources and, for
// each source, in ascending order of the partners' tags. If all claims on a ring are on the rank
// that owns it, the terms are summed directly in the order of the calls, which is the same order.
#pragma once

#include "../core/numbers/vec3.h"
#include "bearing_compat.h"
#include "lammps.h"

#include <functional>
#include <vector>

namespace bearing {

class RingSum : protected LAMMPS_NS::Pointers {
 public:
  enum Source { rail, pocket, land, ball };    // in the order in which they are added
  explicit RingSum(LAMMPS_NS::LAMMPS *lmp) : Pointers(lmp) {}

  void reset();    // clears all claims; must be called on all ranks after a neighbour build
  void own(int i_ring, tag_t ring);
  // Claims a term in the sum over a ring owned by the rank `owner`, and returns its index, which is
  // valid until reset(). All claims must be made before the first flush().
  int claim(tag_t ring, int owner, Source source, tag_t partner);

  void add(int claim, const raceway::Vec3 &force, const raceway::Vec3 &torque)
  {
    Share &p = shares_[claim];
    if (p.direct >= 0) {
      rings_[p.direct].force += force;
      rings_[p.direct].torque += torque;
    } else {
      force.to(p.said);
      torque.to(p.said + 3);
    }
  }
  void flush();    // adds the sums to atom->f and atom->torque of owned rings; must be called on
                   // all ranks

  // Owned rings in the order of tags, with their local indices and the force and torque at the last
  // flush().
  int rings() const { return static_cast<int>(rings_.size()); }
  int ring(int n) const { return rings_[n].i; }
  const raceway::Vec3 &force(int n) const { return rings_[n].summed[0]; }
  const raceway::Vec3 &torque(int n) const { return rings_[n].summed[1]; }
  // Sends other numbers along the same paths. `said` has `width` numbers per claim; heard(n,
  // source, numbers) is called for every claim on the n-th owned ring, ring by ring and in the
  // order of the sums. Must be called on all ranks after a flush().
  void collect(int width, const std::vector<double> &said,
               const std::function<void(int n, Source, const double *)> &heard);
  int claims() const { return static_cast<int>(shares_.size()); }

 private:
  static constexpr int force_and_torque = 6;
  struct Claim {
    tag_t ring, partner;
    int source;
  };
  struct Share {
    double said[force_and_torque];
    int direct;
  };    // direct: index of a ring with local claims only, or -1
  struct Term {
    tag_t partner;
    int source, letter, at;
  };    // letter: -1 if the claim is of this rank
  struct OwnedRing {
    int i;
    tag_t tag;
    bool local;
    std::vector<Term> terms;    // in the order of the sum
    raceway::Vec3 force, torque, summed[2];
  };
  struct Letter {
    int rank;
    std::vector<int> claims;    // claims of this rank that are contained in an outgoing letter
    int terms;
    std::vector<double> text;
  };

  void find_ways();
  template <class Said> void send(int width, Said said);

  bool ways_known_ = false;
  std::vector<Claim> claims_;
  std::vector<int> owner_;    // rank that owns the ring of each claim
  std::vector<Share> shares_;
  std::vector<OwnedRing> rings_;    // owned rings, sorted by tag
  std::vector<Letter> out_, in_;
};

}    // namespace bearing
