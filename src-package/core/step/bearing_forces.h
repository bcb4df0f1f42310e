// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of one bearing, and on request their derivatives, at the present state of its bodies:
// raceway contacts (raceway_contacts.cpp) and cage contacts (cage_contacts.cpp).
#ifndef RACEWAY_BEARING_FORCES_H
#define RACEWAY_BEARING_FORCES_H

#include "../bodies/bearing_bodies.h"

namespace raceway {

class BearingSystem;

enum class Evaluate {
  only,          // forces on rings, power, energy; without looks the right-hand side, too
  residual,      // forces on rings, the right-hand side of the linear system
  derivatives    // and its matrix
};

// Why there is no result.
enum class Failure {
  none,
  not_a_number,      // a velocity is no number
  outside_groove,    // a ball is farther in or out than the overlap limit
  turned_too_far,    // a body turns too far for one stage
  overlinked,        // a body has more than two closed cage contacts
  other_links,       // other cage contacts are closed than at the last factorisation
  not_converged      // more corrections than allowed
};

// Four contacts as an evaluation finds them. Vectors of the state are in the lab.
struct alignas(32) ContactLook {
  ContactStateT<Lane> state;
  LaneMask live;    // the state is set where they are; elsewhere its motions, if gaps are wanted
  Lane orbit;       // rad/s, of the ball about the ring's axis; the surfaces need not touch
};

// m, overlap that an open contact is taken to have where its derivatives are asked for
static constexpr double barely_touching = 1e-9;

// What is evaluated.
struct Stage {
  double h = 0.0;               // s, its length
  bool dampers_only = false;    // positions are given: springs have no derivative
  Evaluate evaluate = Evaluate::only;
  ContactLook *looks = nullptr;    // by group of contacts, with `only`: they and forces on rings
  bool gaps = false;               // look at surfaces that do not touch, too
  // m, gaps of balls and of cage balls that count as touching in the derivatives: a body that rests
  // would leap from its groove else
  double close = 0.0, close_cage = 0.0;

  double follows() const { return dampers_only ? 0.0 : h; }    // s, positions follow velocities
};

class BearingForces {
 public:
  BearingForces(BearingBodies &, BearingSystem &);

  Failure evaluate(const Stage &);
  // What contacts keep, after a correction that came from the last evaluation (kept_follow.h).
  // False: it changes by more than a contact's spring does over `exact`, m.
  bool follow(double exact);
  // How long a step from here may be for the flaws of raceways and balls, s.
  double longest_step() const;

  // Of a ball and a raceway at the start of the step, m; 0 where none touches.
  double largest_overlap() const;

  int body() const { return body_; }                           // that a failure is about, or -1
  double power_lost() const { return power_lost_; }            // W, in contacts
  double contact_energy() const { return contact_energy_; }    // J, of their springs

 private:
  template <class L> RACEWAY_INLINE Failure raceways(const L &law, const Stage &);
  Failure all_raceways(const Stage &);
  double longest_step_of_balls() const;
  template <class... Families> RACEWAY_INLINE bool fused(const Stage &, Failure &);
  // Smooth raceways with a law of inputs/models; false if the law is another one.
  bool paper_raceways(const Stage &, Failure &);
  bool full_raceways(const Stage &, Failure &);
  // Raceways, smooth or not, with any set of parts.
  Failure any_raceways(const Stage &);
  Failure narrow_raceways(const Stage &);    // for processors without AVX2
  void rails(const Stage &);
  Failure pockets(const Stage &);

  struct Place {
    double x[3], v[3];
  };

  BearingBodies &b_;
  BearingSystem &system_;
  double power_lost_ = 0.0, contact_energy_ = 0.0;
  int body_ = -1;
  ProfiledContactT<Lane> on_;              // four contacts on a raceway with a profile
  BallSlopesT<Lane> turned_;               // of balls with one
  std::vector<int> touching_, touched_;    // closed pockets now and at the last factorisation
  std::vector<Place> place_;               // lab, by slot; only bodies with pockets
  std::vector<char> in_pocket_;            // groups
};

}    // namespace raceway

#endif
