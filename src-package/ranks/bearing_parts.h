// SPDX-License-Identifier: GPL-2.0-or-later
// The bearings of a box, each whole on one rank: what an implicit integrator needs, since it solves
// for all bodies of a bearing at once.
//
// A bearing is everything connected through possible contacts. Its home is the rank that owns its
// ring of lowest tag. build() finds the bearings after a neighbour build and sends what they are
// made of to their homes; every step gather() brings the state of the bodies there and scatter()
// brings it back to the owners of the atoms. A model lists everything by tag, so nothing that is
// computed from it depends on the number of ranks. Messages go from owner to home and back only,
// one a pair of ranks; a bearing that lies on its home rank alone costs none.
#ifndef BEARING_BEARING_PARTS_H
#define BEARING_BEARING_PARTS_H

#include "../styles/fix_bearing_ring.h"
#include "bearing_compat.h"

#include <unordered_map>
#include <vector>

namespace LAMMPS_NS {
class FixBearingCage;
class PairBearingHertz;
}
namespace raceway {
struct RacewayPhysics;
}

namespace bearing {

// One bearing, on its home rank; indices point into bodies and rings.
struct PartModel {
  struct Body {
    tag_t tag;
    double mass, radius;
    bool spins;
  };
  struct Ring {
    tag_t tag;
    LAMMPS_NS::FixBearingRing *fix;    // null: at rest
    std::vector<LAMMPS_NS::FixBearingRing::OwnValue> own;
  };
  struct Groove {
    int body, ring;
    const raceway::RacewayPhysics *physics;
  };
  struct Pocket {
    int a, b;
    double K, reach, mass;
  };    // contact of two spheres
  struct Seat {
    int body, ring;
    const LAMMPS_NS::FixBearingCage *cage;
  };    // a cage ball on its rails

  std::vector<Body> bodies;       // rolling balls (spins) first, then cage balls, each by tag
  std::vector<Ring> rings;        // by tag
  std::vector<Groove> grooves;    // by body, then ring
  std::vector<Pocket> pockets;    // by smaller tag, then larger
  std::vector<Seat> seats;        // by fix, then body

  tag_t name() const { return rings.front().tag; }
};

struct BodyState {
  raceway::Vec3 x, v, w;
};
struct RingFullState {
  raceway::Vec3 x, v, w;
  LAMMPS_NS::FixBearingState::RingMotion motion;
};

class BearingParts : protected LAMMPS_NS::Pointers {
 public:
  // command: what messages begin with
  BearingParts(LAMMPS_NS::LAMMPS *lmp, const std::string &command) :
      Pointers(lmp), command_(command)
  {
  }

  // All bearings with atoms of the group; error if such an atom is part of none, or a bearing only
  // partly in the group.
  void build(LAMMPS_NS::PairBearingHertz *, int groupbit);

  int size() const { return static_cast<int>(parts_.size()); }    // bearings at home here, by name
  const PartModel &model(int p) const { return parts_[p].model; }
  std::vector<BodyState> &bodies(int p) { return parts_[p].bodies; }
  std::vector<RingFullState> &rings(int p) { return parts_[p].rings; }

  void gather();     // from the atoms of all ranks to the homes
  void scatter();    // and back

 private:
  struct Part {
    PartModel model;
    std::vector<BodyState> bodies;
    std::vector<RingFullState> rings;
  };
  struct Bearing {
    tag_t name;
    int home;
    bool inside;
  };    // what all ranks know; inside: has atoms of the group
  struct Piece;    // of a model, on the way to its home
  struct Place {
    int part, at;
  };
  struct Local {
    int i;
    Place place;
  };    // an atom whose home is here too
  struct Letter {    // to or from another rank, bodies then rings
    int rank;
    std::vector<int> body_atom, ring_atom;        // at the owner
    std::vector<Place> body_place, ring_place;    // at home
    std::vector<double> text;
    void size_text();
  };

  std::vector<int> find_bearings(int groupbit, std::vector<Bearing> &);
  std::vector<std::vector<Piece>> cut(const std::vector<int> &bearing_of,
                                      const std::vector<Bearing> &, int groupbit);
  void assemble(const std::vector<std::vector<Piece>> &);
  void finish(const std::vector<Piece> &, const std::unordered_map<tag_t, int> &part_of,
              const std::vector<std::unordered_map<tag_t, int>> &at);
  BodyState read_body(int i) const;
  RingFullState read_ring(int i) const;
  void write_body(int i, const BodyState &) const;
  void write_ring(int i, const RingFullState &) const;

  std::string command_;
  LAMMPS_NS::PairBearingHertz *pair_ = nullptr;
  std::vector<Part> parts_;
  std::vector<Local> own_bodies_, own_rings_;
  std::vector<Letter> away_;      // atoms owned here, at home elsewhere
  std::vector<Letter> guests_;    // atoms owned elsewhere, at home here
};

}    // namespace bearing

#endif
