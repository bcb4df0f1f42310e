// SPDX-License-Identifier: GPL-2.0-or-later
// One implicit step of one bearing.
//
// A stage of length h looks for the velocities V at its end with
//   M (V - V_base) = h F(q_base + h V, V)
// (q and V in each body's turning frame, lane_frame.h) by Newton's method. Order 1 is one such
// stage over the whole step: backward Euler. Order 2 makes two of length g h, g = 1 - sqrt(1/2):
// the first from the start of the step, the second from start + (1 + sqrt 2) (first - start); its
// end is the end of the step. That is the L-stable diagonally implicit Runge-Kutta method of
// Alexander (SIAM J. Numer. Anal. 14, 1977): nothing of an earlier step is needed.
//
// With dampers_only what depends on velocities is implicit and springs are as in velocity Verlet:
// half a step of drift,
//   M (V - V_start) = h F(q_middle, V)
// by the same Newton's method without the springs' derivatives, and the other half of the drift. It
// keeps vibrations that the stages above damp away and has a stability limit, that of the springs:
// h^2 k = 4 (m + h c/2) for one body on springs k and dampers c, of which three quarters are
// allowed.
//
// Estimated local error, m: how far a ball across the raceways or a ring would be off if only the
// first order counted, g h |V_2 - V_1| (order 1: h |V - V_start|/2). It is an upper bound for
// order 2. With dampers_only: how far it moved across the raceways in the step, which is what a
// ball may be late in meeting a groove. A cage ball may be off by a multiple of that: its contacts
// are soft, and where the cage drives balls its vibration would set the step.
//
// A ball that carries less than a hundredth of the largest load counts for less, down to a tenth,
// by the stiffness of its contacts: balls without load rattle by nanometres that no load feels.
//
// A relative tolerance is a share of the largest overlap of a ball and a raceway at the start of
// the step, where that is more than the tolerance in m. It follows from the state alone, so a
// restart repeats its bits.
//
// Bodies four by four: bearing_bodies.h; forces and derivatives: bearing_forces.h; the linear
// solve: bearing_system.h; contacts between two steps: bearing_instants.h.
#ifndef RACEWAY_BEARING_STEP_H
#define RACEWAY_BEARING_STEP_H

#include "bearing_forces.h"
#include "bearing_instants.h"
#include "bearing_system.h"

namespace raceway {

class BearingStep {
 public:
  struct Settings {
    int order = 2;
    bool dampers_only = false;
    double newton = 1e-7;     // m, what the last correction of a stage may move
    double cage = 1.0;        // so many times as far may a cage ball be off as a ball or ring
    double relative = 0.0;    // newton is at least this share of the largest overlap; 0: not asked
    double error = 1.0;       // over newton: the estimated error that a step may make
    int corrections = 8;      // most of a stage

    // what counts of a cage ball's error
    double cage_error() const { return cage > error ? error / cage : 1.0; }
    // The same for bodies whose largest overlap this is, m. A cage ball may be off as far as
    // before, but for the tolerance of the others.
    Settings at(double overlap) const;
  };
  struct Outcome {
    Failure failure = Failure::not_converged;
    int body = -1;    // that the failure is about, or -1
    int corrections = 0;
    double tolerance = 0.0;     // m, what the estimated error may be
    double error = HUGE_VAL;    // m, estimated
    double stability = 0.0;     // h^2 over the largest that is allowed; grows like h^2
    double last = HUGE_VAL;     // m, last correction

    bool solved() const { return failure == Failure::none; }
  };
  // N m/s summed over a step; the integrator's own loss is what is missing between them.
  struct Energy {
    double work = 0.0;          // J, put in by loads and drives
    double dissipated = 0.0;    // J, in films, by hysteresis, by sliding and at the cage
    double stored = 0.0;        // J, now: motion and contact springs
  };

  explicit BearingStep(const BearingModel &);
  BearingStep(const BearingStep &) = delete;    // its pieces refer to one another
  const BearingModel &model() const { return bodies_.model; }

  void load(const std::vector<BodyPose> &b, const std::vector<RingPose> &r) { bodies_.load(b, r); }
  void store(std::vector<BodyPose> &b, std::vector<RingPose> &r) const { bodies_.store(b, r); }
  // Of a ring of the model; the shafts are numbered after them.
  void set_program(int ring, const RingProgram &p) { bodies_.rings[ring].program = p; }
  // Of a shaft of the model that bends: what loads do to its modes, and where these are.
  void set_bend(int shaft, const BendProgram &p) { bend(shaft).program = p; }
  void load_bend(int shaft, const BendState &b) { bend(shaft).from = b; }    // before load()
  const BendState &stored_bend(int shaft) { return bend(shaft).from; }
  void set_gravity(const Vec3 &g)    // m/s^2
  {
    bodies_.gravity = g;
    bodies_.heavy = dot(g, g) > 0.0;
  }
  // What the contacts keep: groove by groove of the model, states() numbers each.
  int states() const { return bodies_.states(); }
  void load_states(const double *values) { bodies_.load_states(values); }
  void store_states(double *values) const { bodies_.store_states(values); }

  // Longest step from here for the flaws of the raceways (core/geometry/raceway_profile.h), s
  double longest_step() const { return forces_.longest_step(); }

  // From share s0 to share s1 of the host's step, h seconds. Nothing has moved until accept().
  Outcome step(const Settings &, double h, double s0, double s1);
  // Failure of the contacts at an instant within the step (bearing_instants.h), which ends the run.
  Failure accept();

  BearingInstants &instants() { return instants_; }
  const BearingInstants &instants() const { return instants_; }

  void keep_energy(bool yes) { keep_energy_ = yes; }
  const Energy &spent() const { return energy_; }    // of all accepted steps, without `stored`
  const Energy &energy();                            // with it

 private:
  ShaftBend &bend(int shaft);
  bool solve_stage(const Settings &, double h, double s, Outcome &);
  bool move(double h, double s, bool dampers_only);
  bool coast(double h, double s, bool to_end);
  double stability(double h) const;
  double lever(const BearingBodies::Free &) const;
  double cage_correction(const Settings &, double h) const;
  double apply(double h, double cage_counts, Outcome &);
  void halve();
  void second_base();
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
  bool keep_energy_ = false;
  Energy energy_, pending_;
  struct {
    double h, s0, s1;
  } present_ = {};    // the step not yet accepted
};

}    // namespace raceway

#endif
