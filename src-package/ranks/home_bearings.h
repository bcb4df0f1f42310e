// SPDX-License-Identifier: GPL-2.0-or-later
// The bearings in the box. Each of them is complete on one rank, because the implicit integrator
// solves for all bodies of a bearing at once.
//
// A bearing consists of everything that is connected through possible contacts. Its home is the
// rank that owns its ring with the lowest tag. After a neighbour build, build() finds the bearings
// and sends their pieces to their homes. In every step, gather() sends the state of the bodies to
// the homes, and scatter() returns it to the owners of the atoms. Everything in a model is sorted
// by tag, so its results do not depend on the number of ranks. Messages are sent only between
// owners and homes, one per pair of ranks; none are needed for a bearing that lies entirely on its
// home rank.
#pragma once

#include "../contacts/cage_pockets.h"
#include "../contacts/cage_rails.h"
#include "../contacts/ring_motion.h"
#include "../core/bodies/bearing_model.h"
#include "../core/figures/contact_table.h"
#include "bearing_compat.h"

#include <functional>
#include <unordered_map>
#include <vector>

namespace bearing {

// Contribution of a rank to the bearings whose atoms it owns.
struct BearingSources {
  struct MovedRing {
    int i;        // owned atom
    int mover;    // index of the fix that moves it, which is the same on all ranks
    std::vector<raceway::RingValue> own;
    tag_t shaft = 0;     // first ring on the shaft that carries the ring; 0 if there is no shaft
    double at = 0.0;     // m, position on the shaft relative to its centre
    tag_t holder = 0;    // ring to which its supports connect; 0 for the ground
  };
  const ContactTable *table = nullptr;
  int states = 0;    // number of state variables of the contact law per contact
  raceway::LabAxes axes;
  std::vector<const CageRails *> cages;           // the same list in the same order on all ranks
  std::vector<const CagePockets *> cage_rings;    // the same order applies as for `cages`
  std::vector<MovedRing> moved;
  std::function<bool(int type)> is_ring, is_ball;
  std::function<const raceway::RacewayPhysics *(int ball_type, int ring_type, int groove)> raceway;
  std::function<const raceway::RacewayProfile *(tag_t ring, const raceway::RacewayPhysics *)>
      profile;    // returns the profile of a raceway or null; may be empty
  std::function<const raceway::BallProfile *(tag_t ball, const raceway::RacewayPhysics *)>
      ball_profile;                                    // profile of a ball or null; may be empty
  std::function<raceway::Quaternion &(int i)> turn;    // orientation of a ball; may be empty
  std::function<RingMotion &(int i)> motion;           // returns the motion of a ring
};

class HomeBearings : protected LAMMPS_NS::Pointers {
 public:
  // `command` is used as the prefix of messages.
  HomeBearings(LAMMPS_NS::LAMMPS *lmp, const std::string &command) :
      Pointers(lmp), command_(command)
  {
  }

  // Finds all bearings with atoms of the group. Stops with an error if an atom of the group belongs
  // to no bearing, or if a bearing is only partly in the group.
  void build(const BearingSources &, int groupbit);

  // Bearings whose home is on this rank, sorted by name.
  int size() const { return static_cast<int>(bearings_.size()); }
  const raceway::BearingModel &model(int p) const { return bearings_[p].model; }
  std::vector<raceway::BodyPose> &bodies(int p) { return bearings_[p].bodies; }
  std::vector<raceway::RingPose> &rings(int p) { return bearings_[p].rings; }
  // State variables of the contacts of bearing p, in the order of the grooves in its model.
  std::vector<double> &states(int p) { return bearings_[p].states; }
  // Next substep (s) requested by the step control, which is stored with the first ring of the
  // bearing.
  double &wished_step(int p) { return bearings_[p].steps.front(); }

  void gather();     // sends the state from the atoms of all ranks to the homes
  void scatter();    // sends the state back

 private:
  struct HomeBearing {
    raceway::BearingModel model;
    std::vector<raceway::BodyPose> bodies;
    std::vector<raceway::RingPose> rings;
    std::vector<double> steps;    // indexed by ring
    std::vector<double> states;
  };
  struct NamedBearing {
    tag_t name;
    int home;
    bool inside;
  };    // known on all ranks; inside: it has atoms of the group
  struct Piece;    // piece of a model that is sent to the home rank
  struct Place {
    int bearing, at;
  };
  struct Local {
    int i;
    Place place;
  };    // an atom that is owned by this rank and whose home is here
  struct LocalContact {
    double *kept;
    Place place;
  };    // contact of a ball that is owned by this rank and whose home is here
  struct Letter {    // message to or from another rank, which contains bodies, rings and contact
                     // states
    int rank;
    std::vector<int> body_atom, ring_atom;                       // of the owner
    std::vector<double *> kept;                                  // of the owner
    std::vector<Place> body_place, ring_place, contact_place;    // of the home
    std::vector<double> text;
    void size_text(int states);
  };

  std::vector<int> find_bearings(int groupbit, std::vector<NamedBearing> &);
  std::vector<std::vector<Piece>> cut(const std::vector<int> &bearing_of,
                                      const std::vector<NamedBearing> &, int groupbit);
  void assemble(const std::vector<std::vector<Piece>> &);
  int groove_of(const raceway::BearingModel &, int body, int ring, const Piece &) const;
  void finish(const std::vector<Piece> &, const std::unordered_map<tag_t, int> &number_of,
              const std::vector<std::unordered_map<tag_t, int>> &at);
  struct SentRing {
    raceway::RingPose pose;
    double step;
  };    // data of a ring that are sent
  raceway::BodyPose read_body(int i) const;
  SentRing read_ring(int i) const;
  void write_body(int i, const raceway::BodyPose &) const;
  void write_ring(int i, const SentRing &) const;
  SentRing ring_at(const Place &) const;
  double *states_at(const Place &p) { return &bearings_[p.bearing].states[p.at * sources_.states]; }
  void put_ring(const Place &, const SentRing &);

  std::string command_;
  BearingSources sources_;
  std::vector<HomeBearing> bearings_;
  std::vector<Local> own_bodies_, own_rings_;
  std::vector<LocalContact> own_contacts_;
  std::vector<Letter> away_;      // atoms owned here whose home is elsewhere
  std::vector<Letter> guests_;    // atoms owned elsewhere whose home is here
};

}    // namespace bearing
