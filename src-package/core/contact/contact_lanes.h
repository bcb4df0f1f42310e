// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts of balls with one groove, evaluated four at a time and without derivatives, for the
// host's step. The result in each lane is bitwise identical to that of the contact evaluated alone.
#pragma once

#include "../raceway/profiled_contact.h"
#include "../raceway/raceway_physics.h"

namespace raceway {

// Position of a contact on a profile of the raceway or of the ball.
struct FlawedPlace {
  bool ring = false, ball = false;    // true for each of them that has a profile
  ProfiledContact on;
  BallSlopes turned;    // slopes of the ball's profile
};

// Contacts of up to four balls with one groove. A lane without a ball refers to the ball of another
// lane and has separate storage for results.
struct ContactLanes {
  struct BallArrays {
    const double *x, *v, *w;    // three components each
  };

  // input, set by the caller
  BallArrays ball[lanes];
  RingState groove;
  double dt = 0.0;        // s, step of the law's state variables
  double *kept[lanes];    // state variables
  bool gaps = false;      // true: also compute the positions and motions of balls that do not touch
  ContactState *state[lanes];
  ContactForces *force[lanes];
  const FlawedPlace *flaw[lanes] = {};    // null: raceway and ball are smooth
  bool flawed = false;                    // at least one element of `flaw` is set
  bool energies = false;                  // stored energies are requested

  bool live[lanes];        // result: in contact
  double energy[lanes];    // J, result: stored energy

  // reused memory; variables that the law does not set keep their old values
  ContactStateT<Lane> all;
};

// Finds the contacts that may touch.
void find_places(const RacewayPhysics &, ContactLanes &);
// Evaluates the law and the kinematics, i.e. the contact states, the forces and, if dt > 0, the
// state variables. The results are valid only for contacts that touch. If the reach of the law is
// 0, all contacts must be near.
void act_in_lanes(const RacewayPhysics &, ContactLanes &);
// Does the same for any law, where each part is a separate function.
void act_by_parts(const RacewayPhysics &, ContactLanes &);

}    // namespace raceway
