// SPDX-License-Identifier: GPL-2.0-or-later
// States of a bearing within a step, for output that is sampled faster than the time step.
// Positions follow the cubic that matches both ends of the internal step (cubic.h), velocities and
// contact states are interpolated linearly, and forces are evaluated in the same way as in the step
// itself. These states do not affect the motion.
#pragma once

#include "../electric/film_capacitor.h"
#include "bearing_forces.h"

#include <vector>

namespace raceway {

// Requested instants, at the fractions k/number of the host's step, k = 1 to number - 1. If
// `number` is 0, there are no instants; if a permittivity is 0, no capacitances are computed.
struct Instants {
  int number = 0;
  bool states = false;                       // true if the states of contacts are also requested
  std::vector<CapacitorModel> capacitors;    // of the contacts on each ring of the model

  bool operator==(const Instants &i) const
  {
    return number == i.number && states == i.states && capacitors == i.capacitors;
  }
};

// A bearing at an instant. The indices are those of the model.
struct BearingAtInstant {
  struct Contact {
    double orbit;                        // rad/s, speed of the ball about the ring's axis
    double load;                         // N
    bool live;                           // true if the contact has a state
    FilmCapacitorT<double> capacitor;    // 0 if not requested
    ContactState state;                  // only if requested and live
  };
  struct Body {
    Vec3 x, v, w;
  };
  struct Ring {
    RingPose pose;
    Vec3 force, moment;    // force (N) and moment (N m) of balls and cage on the ring
    Vec3 acceleration;     // m/s^2
  };
  std::vector<Contact> contacts;    // indexed by groove
  std::vector<Body> bodies;
  std::vector<Ring> rings;
};

class BearingInstants {
 public:
  BearingInstants(BearingBodies &b, BearingForces &f) : b_(b), forces_(f) {}

  void want(const Instants &);
  const Instants &wanted() const { return instants_; }
  // Results go to `to`, which the caller keeps: alike bearings share a solver. Must be called
  // before each host step.
  void write_to(std::vector<BearingAtInstant> &to);

  // Evaluates the instants within a step of h seconds before the step is accepted. The step extends
  // from the fraction s0 to the fraction s1 of the host's step.
  Failure pass(double h, double s0, double s1);

 private:
  struct alignas(32) Motion {    // motion of a group
    LaneFrame frame;
    Vec3L v, w;
  };
  struct alignas(32) Bodies {    // bodies of a group in the lab frame
    Vec3L x, v, w;
  };
  struct alignas(32) Capacitors {    // capacitors of a group of contacts
    FilmCapacitorT<Lane> of;
  };
  void keep();
  void put_back();
  void move(double h, double s);
  Failure look_at(double s, BearingAtInstant &to);
  void capacitors();
  void store_contacts(std::vector<BearingAtInstant::Contact> &to);
  void store_bodies(std::vector<BearingAtInstant::Body> &to);
  void store_rings(double s, std::vector<BearingAtInstant::Ring> &to);

  BearingBodies &b_;
  BearingForces &forces_;
  Instants instants_;
  int next_ = 1;
  std::vector<BearingAtInstant> *to_ = nullptr;
  // indexed by contact group, at the instant that is being evaluated
  std::vector<ContactLook> looks_;
  std::vector<Capacitors> capacitors_;
  std::vector<CapacitorModel> models_;           // indexed by track
  std::vector<SurroundedRaceway> surrounded_;    // indexed by track; empty if no surroundings are
                                                 // requested
  // state at the end of the step, saved while the bearing is moved to an instant
  std::vector<Motion> end_;
  std::vector<BearingBodies::States> kept_end_;
};

}    // namespace raceway
