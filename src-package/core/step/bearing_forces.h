// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the forces in one bearing for the current state of its bodies, optionally with
// derivatives: raceway contacts (raceway_contacts.cpp), cage balls (cage_contacts.cpp), and
// one-piece cages (cage_ring_forces.cpp).
#pragma once

#include "../bodies/bearing_bodies.h"
#include "../geometry/pocket_contact.h"
#include "cage_axes.h"

namespace raceway {

class BearingSystem;

enum class Evaluate {
  only,          // forces on rings, power and energy; if there are no `looks`, also the right-hand
                 // side
  residual,      // forces on rings, and the right-hand side of the linear system
  derivatives    // as `residual`, plus the matrix of the linear system
};

// Reason why a step has no result.
enum class Failure {
  none,
  not_a_number,      // a velocity is NaN or infinite
  outside_groove,    // a ball is outside the groove by more than the overlap limit
  turned_too_far,    // a body turns too far in one stage
  overlinked,        // a body has more than two closed cage contacts
  other_links,       // closed cage contacts differ from those of the last factorisation
  not_converged      // maximum number of corrections reached
};

// Results for four contacts. The vectors of the state refer to the lab frame.
struct alignas(32) ContactLook {
  ContactStateT<Lane> state;
  LaneMask live;    // contacts with a state; if gaps are requested, all others have motions only
  Lane orbit;       // rad/s, speed of the ball about the ring's axis, also set if there is no
                    // contact
};

// Overlap assumed for an open contact whose derivatives are needed, m.
static constexpr double barely_touching = 1e-9;

// Effects of the oil in the pockets on a cage, summed over groups of balls.
struct PocketSums {
  Vec3L force, moment;                                         // on the balls, N; on the cage, N m
  Lane loss = {};                                              // W
  Lane corner[RingProgram::N_DOF][RingProgram::N_DOF] = {};    // added to D (BearingSystem)
  int column[RingProgram::N_DOF], columns = 0;
};

// Settings of an evaluation.
struct Stage {
  double h = 0.0;               // s, length of the stage
  bool dampers_only = false;    // positions are given: springs have no derivative
  Evaluate evaluate = Evaluate::only;
  ContactLook *looks = nullptr;    // with `only`: results for each group of contacts, which are
                                   // filled in together with the forces on rings
  bool keep = false;               // with `derivatives`: call BearingSystem::keep() after the
                                   // raceways
  bool kept = false;    // with `derivatives`: use the kept raceways, updated for the last
                        // correction
  bool gaps = false;    // also evaluate contacts whose surfaces do not touch
  // Largest gaps (m) at balls and at cage balls for which derivatives are evaluated as for a closed
  // contact. Without these derivatives, a body at rest would jump out of its groove.
  double close = 0.0, close_cage = 0.0;

  double follows() const { return dampers_only ? 0.0 : h; }    // s, time over which positions
                                                               // follow velocities
};

class BearingForces {
 public:
  BearingForces(BearingBodies &, BearingSystem &);

  Failure evaluate(const Stage &);
  // Updates the states of the contacts after a correction, based on the last evaluation
  // (kept_follow.h). Returns false if a state changes by more than the contact's spring force over
  // the distance `exact` (m).
  bool follow(double exact);
  // Returns the longest step (s) from the current state that is permitted by the profiles of
  // raceways and balls.
  double longest_step() const;

  // Returns the largest overlap between a ball and a raceway at the start of the step, m, or 0 if
  // there is no contact.
  double largest_overlap() const;

  int body() const { return body_; }                           // body that caused the failure, or
                                                               // -1
  double power_lost() const { return power_lost_; }            // power dissipated in contacts, W
  double contact_energy() const { return contact_energy_; }    // elastic energy of contacts, J
  // Returns the change (J) in elastic energy since the start of the step due to entrainment speeds
  // and contact angles: thicker films load the contacts, and no force does work when a contact
  // angle changes.
  double energy_gained() const { return energy_gained_; }

 private:
  template <class L> RACEWAY_INLINE Failure raceways(const L &law, const Stage &);
  Failure all_raceways(const Stage &);
  double longest_step_of_balls() const;
  template <class... Families> RACEWAY_INLINE bool fused(const Stage &, Failure &);
  // Evaluates smooth raceways whose law is one of those in inputs/models. Returns false for any
  // other law.
  bool paper_raceways(const Stage &, Failure &);
  bool full_raceways(const Stage &, Failure &);
  // Evaluates raceways, with or without profiles, with any set of parts.
  Failure any_raceways(const Stage &);
  Failure narrow_raceways(const Stage &);    // for processors without AVX2
  void rails(const Stage &);
  Failure pockets(const Stage &);
  // cage_ring_forces.cpp
  void cages(const Stage &);
  RACEWAY_INLINE void pockets_of(const Stage &, const BearingModel::Cage &, const CageMotion &,
                                 const Vec3L &axis, const BearingBodies::Cell &, PocketSums &);
  RACEWAY_INLINE void film_rows(const Stage &, const BearingModel::Cage &,
                                const BearingBodies::Cell &, const PocketGapT<Lane> &,
                                const PocketOilT<Lane> &, const CageAxesT<Lane> &, PocketSums &);
  void wall(const Stage &, const BearingModel::Cage &, const PocketGapT<double> &,
            const PocketWall &, const CageAxesT<double> &, int group, int lane);
  void land(const Stage &, const BearingModel::Cage &, const CageMotion &);

  struct Place {
    double x[3], v[3];
  };

  BearingBodies &b_;
  BearingSystem &system_;
  double power_lost_ = 0.0, contact_energy_ = 0.0, energy_gained_ = 0.0;
  int body_ = -1;
  ProfiledContactT<Lane> on_;              // four contacts on a raceway with a profile
  BallSlopesT<Lane> turned_;               // slopes of balls with a profile
  std::vector<int> touching_, touched_;    // closed pockets now and at the last factorisation
  std::vector<Place> place_;               // in the lab frame, indexed by slot; only for bodies
                                           // with pockets
  std::vector<char> in_pocket_;            // by group
};

}    // namespace raceway
