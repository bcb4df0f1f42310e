// SPDX-License-Identifier: GPL-2.0-or-later
// Performs one implicit step for one bearing.
//
// A stage of length h solves for the velocities V at its end,
//   M (V - V_base) = h F(q_base + h V, V)
// by Newton's method, where q and V refer to the rotating frame of each body (lane_frame.h). The
// first-order method consists of one such stage over the whole step, i.e. backward Euler. The
// second-order method consists of two stages of length g h, g = 1 - sqrt(1/2). The first starts at
// the start of the step, the second at the base start + (1 + sqrt 2) (first - start); the end of
// the second stage is the end of the step. This is the L-stable diagonally implicit Runge-Kutta
// method of Alexander (SIAM J. Numer. Anal. 14, 1977), which needs no data from earlier steps.
//
// With dampers_only, forces that depend on velocities are implicit, whereas springs are treated as
// in velocity Verlet: there is half a step of drift, then the equation
//   M (V - V_start) = h F(q_middle, V)
// is solved by the same Newton iteration without the derivatives of the springs, followed by the
// other half of the drift. This mode preserves vibrations that the stages above would damp out, and
// its stability limit is that of the springs: h^2 k = 4 (m + h c/2) for one body with springs k and
// dampers c. Steps are limited to three quarters of this value.
//
// The estimated local error (m) is the error of a ball normal to the rolling direction, or of a
// ring, if the method were of first order: g h |V_2 - V_1| (order 1: h |V - V_start|/2). For order
// 2 this is an upper bound. With dampers_only, the estimate is the distance that a body moves
// normal to the rolling direction during the step, because the contact of a ball with a groove may
// be detected too late by that distance. The allowed error of a cage ball is larger than that of a
// ball, because the contacts of cage balls are soft and, if the cage drives balls, the vibration of
// the cage would otherwise determine the step.
//
// With `estimate` the error is four times the second-order error, which is computed from the second
// difference of the velocities at the start and at the ends of both stages, or 0.7 of the upper
// bound (0.3 with a relative tolerance) if that is larger. A stage ends when all further
// corrections would be below the tolerance if they continued to decrease at the current rate. If
// balls and rings have converged but the cage has not, further corrections extrapolate the raceway
// contacts from their derivatives.
//
// The error of a ball that carries less than a hundredth of the largest load is weighted by the
// stiffness of the ball's contacts, with a weight of at least a tenth, because unloaded balls
// rattle by nanometres without affecting any load. In a bearing with a one-piece cage, the error of
// each ball is expressed as an error of its load, with a weight of at least 1/200.
//
// A relative tolerance is a fraction of the largest overlap between a ball and a raceway at the
// start of the step; it is used if it exceeds the tolerance in m. It depends only on the state, so
// a restarted run is bitwise identical.
//
// Related files: bearing_bodies.h (bodies in groups of four), bearing_forces.h (forces and
// derivatives), bearing_system.h (linear solve), bearing_instants.h (states within a step).
#pragma once

#include "bearing_forces.h"
#include "bearing_instants.h"
#include "bearing_system.h"

namespace raceway {

class BearingIntegrator {
 public:
  struct Settings {
    int order = 2;
    bool dampers_only = false;
    double newton = 1e-7;     // m, largest value allowed for the last correction of a stage
    double cage = 1.0;        // tolerance for a cage ball divided by that for a ball or a ring
    double relative = 0.0;    // newton is at least this fraction of the largest overlap; 0: unused
    double error = 1.0;       // allowed estimated error of a step divided by `newton`
    int corrections = 8;      // maximum per stage
    bool estimate = false;    // control the step by error estimates instead of bounds; order 2 only

    // weight of a cage ball's error
    double cage_error() const { return cage > error ? error / cage : 1.0; }
    // Returns the settings for a bearing in which the largest overlap is `overlap` (m). The
    // tolerance for cage balls changes only together with the tolerance for the other bodies.
    Settings at(double overlap) const;
  };
  struct Outcome {
    Failure failure = Failure::not_converged;
    int body = -1;    // body that caused the failure, or -1
    int corrections = 0;
    double tolerance = 0.0;     // m, largest allowed estimated error
    double error = HUGE_VAL;    // m, estimated
    double stability = 0.0;     // h^2 divided by its stability limit
    double last = HUGE_VAL;     // m, last correction
    double last_cage = 0.0;     // m, last correction of the cage, multiplied by its weight

    bool solved() const { return failure == Failure::none; }
  };
  // Sums over a step. The residual of the balance is the energy dissipated by the integrator
  // itself.
  struct Energy {
    double work = 0.0;          // J, work of loads and drives
    double dissipated = 0.0;    // J, in films, by hysteresis, by sliding and at the cage
    double stored = 0.0;        // J, current value: kinetic energy and energy of the contact
                                // springs
  };

  explicit BearingIntegrator(const BearingModel &);
  BearingIntegrator(const BearingIntegrator &) = delete;    // its members refer to one another
  const BearingModel &model() const { return bodies_.model; }

  void load(const std::vector<BodyPose> &b, const std::vector<RingPose> &r) { bodies_.load(b, r); }
  void store(std::vector<BodyPose> &b, std::vector<RingPose> &r) const { bodies_.store(b, r); }
  // Sets the program of a ring of the model; shafts are numbered after the rings.
  void set_program(int ring, const RingProgram &p) { bodies_.rings[ring].program = p; }
  // Set the modal loads, and set or return the modal state, of a flexible shaft of the model.
  void set_bend(int shaft, const BendProgram &p) { bend(shaft).program = p; }
  void load_bend(int shaft, const BendState &b) { bend(shaft).from = b; }    // before load()
  const BendState &stored_bend(int shaft) { return bend(shaft).from; }
  void set_gravity(const Vec3 &g)    // m/s^2
  {
    bodies_.gravity = g;
    bodies_.heavy = dot(g, g) > 0.0;
  }
  // State variables of the contacts in the order of the model's grooves, with states() values per
  // groove.
  int states() const { return bodies_.states(); }
  void load_states(const double *values) { bodies_.load_states(values); }
  void store_states(double *values) const { bodies_.store_states(values); }

  // Returns the longest next step permitted by raceway profiles, s
  // (core/geometry/raceway_profile.h).
  double longest_step() const { return forces_.longest_step(); }

  // Computes a step of h seconds from the fraction s0 to the fraction s1 of the host's step.
  // Nothing moves until accept() is called.
  Outcome step(const Settings &, double h, double s0, double s1);
  // Accepts the step. Returns a failure of the contacts at an instant within the step
  // (bearing_instants.h), which ends the run.
  Failure accept();

  BearingInstants &instants() { return instants_; }
  const BearingInstants &instants() const { return instants_; }

  void keep_energy(bool yes);
  const Energy &spent() const { return energy_; }    // sums over accepted steps, without `stored`
  const Energy &energy();                            // including `stored`

 private:
  ShaftBend &bend(int shaft);
  bool solve_stage(const Settings &, double h, double s, Outcome &);
  bool move(double h, double s, bool dampers_only);
  bool coast(double h, double s, bool to_end);
  double stability(double h) const;
  double ball_radius() const { return bodies_.groups.front().now.r[0]; }    // m, orbital radius
  double cage_correction(const Settings &, double h) const;
  void apply(double h, double cage_counts, Outcome &);
  void halve();
  double largest_stiffness() const;
  double error(double h, const Settings &) const;
  void add_energy(const Stage &, double weight, double s);
  double power_of_residual(double h) const;
  double power_of_gravity(double old_share) const;
  double stored_energy();

  BearingBodies bodies_;
  BearingSystem system_;
  BearingForces forces_;
  BearingInstants instants_;
  const double slowest_;
  double remains_ = 1.0;    // last estimate of the error that remains after a correction, divided
                            // by that correction
  bool keep_energy_ = false, balanced_ = false;    // balanced_: the energy balance has been
                                                   // computed at the start of the step
  std::vector<double> loads_;                      // loads on the coordinates
  Energy energy_, pending_;
  struct {
    double h, s0, s1;
  } present_ = {};    // the step that has not been accepted yet
};

}    // namespace raceway
