// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies and rings of one bearing, laid out for the implicit step: four bodies side by side, balls
// on the same raceways and cage balls on the same rails next to each other.
#ifndef RACEWAY_BEARING_BODIES_H
#define RACEWAY_BEARING_BODIES_H

#include "ball_turns.h"
#include "bearing_model.h"
#include "body_group.h"
#include "kept_follow.h"
#include "shaft_bend.h"

namespace raceway {

struct alignas(32) RingBody {
  Vec3L force_lanes, moment_lanes;
  RingProgram program;
  RingPose from, base, now, first;
  double gained[RingProgram::N_DOF] = {};
  int unknown[RingProgram::N_DOF];    // number of a free degree of freedom, else -1; of a ring on
                                      // a shaft that bends: its column (BearingBodies::columns)
  bool loose = false;                 // some degree of freedom is free
  bool carried = false;               // by a shaft
  bool levered = false;               // by a rigid one, whose unknowns it has
  int holder = -1;                    // ring that its supports hold it to, -1: the ground
  int bend = -1;                      // of a shaft that bends: in BearingBodies::bends
  bool holds = false;                 // another one
  bool empty = false;                 // without a raceway: a housing
  double at = 0.0;                    // m, a carried ring from the shaft's centre
  double span = 0.0;                  // m, of a shaft: to the farthest of its rings
  double spring = 0.0;                // N/m, sum over contacts; with dampers_only
  Vec3 force, moment;                 // of the contacts: sums of the lanes
};

class BearingBodies {
 public:
  explicit BearingBodies(const BearingModel &);

  void load(const std::vector<BodyPose> &, const std::vector<RingPose> &);
  void store(std::vector<BodyPose> &, std::vector<RingPose> &) const;
  void accept();        // what is now is the start of the next step
  void carry();         // rings to where their shafts are now
  void add_shafts();    // forces and moments of carried rings on their shafts
  // What the supports of a ring see of it: from its holder, if it has one; of a shaft that bends,
  // its centre.
  RingPose held(const RingBody &r) const
  {
    if (r.bend >= 0) return bends[r.bend].bent_centre(r.now);
    return r.holder < 0 ? r.now : seen_from(r.now, rings[r.holder].now);
  }
  // N, on a ring at the share s of the host's step: contacts, loads, supports and weight.
  Vec3 force_on(const RingBody &, double s) const;
  Vec3 moment_on(const RingBody &, double s) const;    // N m, likewise
  // N and N m, of supports that hold other rings to this one.
  void add_held(const RingBody &, Vec3 *force, Vec3 *moment) const;

  // What contacts keep (part.h), groove by groove of the model, `states` numbers each.
  int states() const { return states_; }
  void load_states(const double *);
  void store_states(double *) const;

  struct Track {    // groups of balls on one raceway
    int ring, first, end;
    const RacewayPhysics *physics;
    const RacewayProfile *profile;
  };
  struct RailTrack {    // groups of cage balls on the rails of one ring
    int ring, first, end;
    const std::vector<Rail> *rails;
    const std::vector<double> *stiffness;
  };
  struct Free {
    int ring, dof;
  };
  struct Carried {
    int ring, shaft;    // both in rings
  };
  struct alignas(32) States {    // of four contacts: numbers of a contact at four instants
    Lane from[most_states], base[most_states], now[most_states], first[most_states];
  };

  BearingModel model;
  std::vector<int> slot, body_at;    // of a body; of a slot (group 4 k + lane), -1: padding
  std::vector<BodyGroup> groups;
  std::vector<Track> tracks;
  bool flawed = false;    // some of them have a profile, or some of the balls
  // By group of contacts, and the rows of their depths; empty if no ball has a profile.
  struct BallProfiles {
    bool any = false;
    const BallProfile *of[lanes] = {};
  };
  std::vector<BallProfiles> ball_profiles;
  std::vector<TurnRowT<Lane>> ball_rows;
  std::vector<BallTurns> turns;    // of groups with such balls
  std::vector<int> turns_at;       // of a group, -1: none
  std::vector<RailTrack> rail_tracks;
  int n_contacts = 0;             // groups of contacts: the sum over the tracks
  std::vector<int> contact_at;    // of a groove of the model: lanes * group of contacts + lane
  std::vector<int> groove_at;     // the reverse, or -1
  std::vector<States> kept;       // by group of contacts, where the law keeps any
  std::vector<KeptSlopes> kept_slopes;
  std::vector<RingBody> rings;    // those of the model, then a shaft each
  std::vector<Carried> on_shafts;
  std::vector<Free> free;    // degrees of freedom of the rings: the border
  // With shafts that bend, their free degrees of freedom are the last ones, and their modes follow.
  std::vector<ShaftBend> bends;
  int unknowns = 0;    // of the border
  // Motions of rings that contacts meet: the first unknowns, but for shafts that bend, then all of
  // each ring on such a shaft.
  int columns = 0, straight = 0;
  // Those that a group may have numbers in, by group: all, or with shafts that bend the ones of its
  // own bearing. With such shafts the same by column.
  std::vector<std::vector<int>> columns_of_group, columns_of_column;
  Vec3 centre;           // of the turning frames
  Vec3 gravity;          // m/s^2, on all bodies and rings
  bool heavy = false;    // there is any

 private:
  void place();
  void find_ball_profiles();
  void place_shafts();
  void find_unknowns();
  void find_unknowns_of(size_t ring);
  void find_columns();
  bool is_bent_shaft(int ring) const;
  bool unknowns_known_ = false;
  int states_ = 0;
};

}    // namespace raceway

#endif
