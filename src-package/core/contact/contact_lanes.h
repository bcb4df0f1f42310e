// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts of balls with one groove, four at a time and without derivatives: what the host's step
// asks for.
// A lane has the bits that a contact alone has.
#ifndef RACEWAY_CONTACT_LANES_H
#define RACEWAY_CONTACT_LANES_H

#include "../raceway/profiled_contact.h"
#include "../raceway/raceway_physics.h"

namespace raceway {

// Where a profile of the raceway or of the ball lets a contact be.
struct FlawedPlace {
  bool ring = false, ball = false;    // which of them has one
  ProfiledContact on;
  BallSlopes turned;    // of the ball's
};

// Contacts of up to four balls with one groove. A lane without a ball takes one that another lane
// has, and places of its own for what is found.
struct ContactLanes {
  struct Ball {
    const double *x, *v, *w;    // three numbers each
  };

  // set by whoever has contacts
  Ball ball[lanes];
  RingState groove;
  double dt = 0.0;        // s, over which the law moves what it keeps
  double *kept[lanes];    // that
  bool gaps = false;      // places and motions of balls that do not touch are wanted
  ContactState *state[lanes];
  ContactForces *force[lanes];
  const FlawedPlace *flaw[lanes] = {};    // null: both are smooth
  bool flawed = false;                    // one of them is not
  bool energies = false;                  // wanted

  bool live[lanes];        // found: they touch
  double energy[lanes];    // J, found: stored in them

  // kept for its memory: what the law does not set stays as it is
  ContactStateT<Lane> all;
};

// Which of them may touch.
void find_places(const RacewayPhysics &, ContactLanes &);
// What law and kinematics make of contacts: states, forces, and with dt > 0 what is kept. Only of
// contacts that touch this has a meaning. Those of a law without a reach must be near.
void act_in_lanes(const RacewayPhysics &, ContactLanes &);
// The same with each part of the law as a function of its own, whatever the law.
void act_by_parts(const RacewayPhysics &, ContactLanes &);

}    // namespace raceway

#endif
