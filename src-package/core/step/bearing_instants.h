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
  std::vector<CapacitorModel> capacitors;    // of the contacts on each ring of the model
};

class BearingInstants {
 public:
  struct ContactAtInstant {
    double orbit;                        // rad/s, speed of the ball about the ring's axis
    double load;                         // N
    bool live;                           // true if the contact has a state
    FilmCapacitorT<double> capacitor;    // 0 if not requested
    ContactState state;                  // only if complete states are requested
  };
  struct RingAtInstant {
    RingPose pose;
    Vec3 force, moment;    // force (N) and moment (N m) of balls and cage on the ring
    Vec3 acceleration;     // m/s^2
  };

  BearingInstants(BearingBodies &b, BearingForces &f) : b_(b), forces_(f) {}

  void want(const Instants &);
  // Results at instant k (from 1) of the last host step; other indices are those of the model.
  void contacts(int k, bool whole_states, std::vector<ContactAtInstant> &) const;    // indexed by
                                                                                     // groove
  BodyPose body(int k, int body) const;
  const RingAtInstant &ring(int k, int ring) const
  {
    return rings_[(k - 1) * b_.rings.size() + ring];
  }

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
  Failure look_at(int k, double s);
  void capacitors(int k);

  BearingBodies &b_;
  BearingForces &forces_;
  Instants instants_;
  int next_ = 1;
  // The outer index is the instant; the inner one is the contact group (looks_, capacitors_), the
  // body group (bodies_) or the ring (rings_).
  std::vector<ContactLook> looks_;
  std::vector<Capacitors> capacitors_;
  std::vector<CapacitorModel> models_;           // indexed by track
  std::vector<SurroundedRaceway> surrounded_;    // indexed by track; empty if no surroundings are
                                                 // requested
  std::vector<Bodies> bodies_;
  std::vector<RingAtInstant> rings_;
  // state at the end of the step, saved while the bearing is moved to an instant
  std::vector<Motion> end_;
  std::vector<BearingBodies::States> kept_end_;
};

}    // namespace raceway
