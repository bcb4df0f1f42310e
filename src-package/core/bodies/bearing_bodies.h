// SPDX-License-Identifier: GPL-2.0-or-later
// Bodies and rings of one bearing in the layout used by the implicit step: four bodies per group,
// with balls on the same raceways and cage balls on the same rails next to each other.
#pragma once

#include "ball_turns.h"
#include "bearing_model.h"
#include "body_group.h"
#include "coordinate.h"
#include "kept_follow.h"
#include "ring_implicit.h"
#include "shaft_bend.h"

namespace raceway {

struct alignas(32) RingBody {
  Vec3L force_lanes, moment_lanes;
  RingProgram program;
  RingPose from, base, now, first, end;
  double gained[RingProgram::N_DOF] = {};
  // Both arrays are indexed by degree of freedom; -1: none. `coordinate` belongs to the ring or to
  // its rigid shaft. `column` (BearingBodies::columns) equals the coordinate, but on a flexible
  // shaft it belongs to the ring alone.
  int coordinate[RingProgram::N_DOF], column[RingProgram::N_DOF];
  bool loose = false;      // at least one degree of freedom is free
  bool carried = false;    // sits on a shaft
  bool levered = false;    // sits on a rigid shaft, whose coordinates it shares
  int holder = -1;         // ring that holds the other end of this ring's supports; -1: ground
  int bend = -1;           // index in BearingBodies::bends if the shaft is flexible
  bool holds = false;      // holds another ring by supports
  bool empty = false;      // has no raceway, as for a housing or a cage
  double pockets = 0.0;    // m, radius of the pocket circle; 0: not a cage
  double at = 0.0;         // m, position of a carried ring relative to the shaft's centre
  double span = 0.0;       // m, for a shaft: distance from its centre to its farthest ring
  double spring = 0.0;     // N/m, summed over the contacts; set only with dampers_only
  Vec3 force, moment;      // contact loads, summed over the lanes

  void start() { base = from; }
  void move(double h, double s) { now = moved(program, base, gained, h, s); }
  void second_base(double beyond_by)
  {
    first = now;
    base = beyond(from, now, beyond_by);
  }
  void accept() { from = now; }
  void keep() { end = now; }    // saves `now` before it is changed
  void put_back() { now = end; }
  void between(double h, double s) { now = raceway::between(from, end, h, s); }
};

class BearingBodies {
 public:
  explicit BearingBodies(const BearingModel &);

  void load(const std::vector<BodyPose> &, const std::vector<RingPose> &);
  void store(std::vector<BodyPose> &, std::vector<RingPose> &) const;
  void start();                       // starts a step
  void second_base(double beyond);    // base = start, moved by `beyond` times the first stage
  void accept();                      // the current state becomes the start of the next step
  void carry();                       // moves carried rings with their shafts
  void add_shafts();                  // adds forces and moments of carried rings to their shafts
  // Calls `act` for each ring and shaft, then for the bending of each flexible shaft.
  template <class Act> void on_border(const Act &act)
  {
    for (RingBody &r : rings) act(r);
    for (ShaftBend &b : bends) act(b);
  }
  // Computes the forces on the coordinates at the fraction s of the host's step, in N or N m,
  // without the moments that the bending of a shaft exerts on the tilts of that shaft.
  void border_forces(double s, std::vector<double> &);
  void border_loads(double s, std::vector<double> &);    // only the forces due to loads and weight
  // Returns the power that contacts and supports transfer to the driven degrees of freedom of a
  // ring, W.
  double power_on_drives(const RingBody &) const;
  // Returns the pose on which the supports of a ring act. It is relative to the ring's holder if
  // there is one; for a flexible shaft, it is the pose of the shaft's centre.
  RingPose held(const RingBody &r) const
  {
    if (r.bend >= 0) return bends[r.bend].bent_centre(r.now);
    return r.holder < 0 ? r.now : seen_from(r.now, rings[r.holder].now);
  }
  // Returns the force (N) of contacts, loads, supports and weight on a ring at the fraction s of
  // the host's step.
  Vec3 force_on(const RingBody &, double s) const;
  Vec3 moment_on(const RingBody &, double s) const;    // N m, due to the same contributions
  // Adds the force (N) and moment (N m) of the supports by which this ring holds other rings.
  void add_held(const RingBody &, Vec3 *force, Vec3 *moment) const;

  // State variables of the contacts (part.h) in the order of the model's grooves, with `states`
  // values per groove.
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
  struct Carried {
    int ring, shaft;    // both are indices into rings
  };
  struct alignas(32) States {    // state variables of four contacts at four instants
    Lane from[most_states], base[most_states], now[most_states], first[most_states];
  };

  BearingModel model;
  std::vector<int> slot, body_at;    // indexed by body; by slot (group 4 k + lane), -1: padding
  std::vector<BodyGroup> groups;
  std::vector<Track> tracks;
  bool flawed = false;    // at least one raceway or ball has a profile
  // Indexed by group of contacts, with the rows of the depths; empty if no ball has a profile.
  struct BallProfiles {
    bool any = false;
    const BallProfile *of[lanes] = {};
  };
  std::vector<BallProfiles> ball_profiles;
  std::vector<TurnRowT<Lane>> ball_rows;
  std::vector<BallTurns> turns;    // orientations in groups with profiled balls
  std::vector<int> turns_at;       // indexed by group, -1: none
  std::vector<RailTrack> rail_tracks;
  // Up to four balls of a one-piece cage, all in one group. A ball stays in its pocket.
  struct alignas(32) Cell {
    Lane cosine, sine;    // of the azimuths of the pockets relative to the first pocket
    LaneMask live;
    int group;
  };
  std::vector<std::vector<Cell>> cells;    // indexed by cage
  int n_contacts = 0;                      // number of contact groups, summed over all tracks
  std::vector<int> contact_at;    // indexed by groove of the model: lanes * contact group + lane
  std::vector<int> groove_at;     // inverse of contact_at, -1: none
  std::vector<States> kept;       // indexed by group of contacts; filled only if the law has state
                                  // variables
  std::vector<KeptSlopes> kept_slopes;
  // Entrainment speed (m/s) and cosine of the contact angle, which together with the overlap
  // determine the elastic energy of a contact; cos_angle < 0 if there is no contact.
  struct EnergyBasis {
    Lane entrainment = {}, cos_angle = all_lanes(-1.0);
  };
  struct alignas(32) BalancedContact {
    EnergyBasis from, now;
  };
  std::vector<BalancedContact> balanced;    // indexed by group of contacts; empty if no energy
                                            // balance is requested
  std::vector<RingBody> rings;              // rings of the model, followed by one ring per shaft
  std::vector<Carried> on_shafts;
  // Free degrees of freedom of rings and rigid shafts, followed by those of flexible shafts and
  // then by the modes.
  std::vector<Coordinate> border;
  std::vector<Coupling> couplings;    // due to supports
  std::vector<ShaftBend> bends;
  // Numbers of ring motions at the contacts. The first `straight` of them are the coordinates,
  // except for those of flexible shafts. They are followed by all motions of each ring on a
  // flexible shaft.
  int columns = 0, straight = 0;
  // Columns of the rings that touch a group: by raceways and by cages or rails. All columns through
  // which rings move the group include those of all groups in the same chain.
  struct GroupColumns {
    std::vector<int> of_raceways, of_cages, all;
  };
  std::vector<GroupColumns> columns_of_group;
  // with flexible shafts, the columns that are coupled to each column
  std::vector<std::vector<int>> columns_of_column;
  Vec3 centre;           // centre of the rotating frames
  Vec3 gravity;          // m/s^2, acts on all bodies and rings
  bool heavy = false;    // gravity is not zero

 private:
  void place();
  void find_ball_profiles();
  void place_shafts();
  void find_border();
  void add_freedoms(RingBody &);
  void add_modes(ShaftBend &);
  void find_couplings();
  void find_columns();
  void find_coupled_columns();
  void find_cells(const std::vector<BodyPose> &);
  int states_ = 0;
};

}    // namespace raceway
