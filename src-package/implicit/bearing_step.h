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
// ball may be late in meeting a groove.
//
// Four balls are computed side by side; a linear solve costs a time proportional to the number of
// balls: each body's own 6x6 (3x3) block is condensed, closed cage contacts are a chain of scalars
// (link_chain.h), and the free degrees of freedom of the rings a small dense border.
#ifndef RACEWAY_BEARING_STEP_H
#define RACEWAY_BEARING_STEP_H

#include "../physics/contact_jacobian.h"
#include "bearing_model.h"
#include "dense_lu.h"
#include "lane_frame.h"
#include "link_chain.h"

namespace raceway {

class BearingStep {
 public:
  struct Settings {
    int order = 2;
    bool dampers_only = false;
    double newton = 1e-7;    // m, what the last correction of a stage may move
    int corrections = 8;     // most of a stage
  };
  struct Outcome {
    bool solved = false;
    int corrections = 0;
    double error = HUGE_VAL;    // m, estimated
    double stability = 0.0;     // h^2 over the largest that is allowed; grows like h^2
    double last = HUGE_VAL;     // m, last correction
  };
  // N m/s summed over a step; the integrator's own loss is what is missing between them.
  struct Energy {
    double work = 0.0;          // J, put in by loads and drives
    double dissipated = 0.0;    // J, in films, by hysteresis, by sliding and at the cage
    double stored = 0.0;        // J, now: motion and contact springs
  };

  // A raceway contact between two steps.
  struct Contact {
    double load, h_c, capacitance;
  };    // N, m, F; all 0 where there is none
  // What of it is wanted: at shares k/number of the host's step, k = 1 to number - 1, for a
  // lubricant of relative permittivity eps and films of at least `shortest` (m). number 0: nothing.
  struct Instants {
    int number = 0;
    double eps = 1.0, shortest = 0.0;
  };

  explicit BearingStep(const BearingModel &);

  void load(const std::vector<BodyPose> &, const std::vector<RingPose> &);
  void store(std::vector<BodyPose> &, std::vector<RingPose> &) const;
  void set_program(int ring, const RingProgram &p) { rings_[ring].program = p; }

  // From share s0 to share s1 of the host's step, h seconds. Nothing has moved until accept().
  Outcome step(const Settings &, double h, double s0, double s1);
  void accept();

  void want(const Instants &);
  Contact
  at_instant(int k, int groove) const;    // k from 1; groove as in the model; of the last host step

  void keep_energy(bool yes) { keep_energy_ = yes; }
  const Energy &spent() const
  {
    return energy_;
  }    // of all accepted steps so far, what is stored now left out
  const Energy &energy();    // with it
  int overlinked() const
  {
    return overlinked_;
  }    // body with more than two closed cage contacts, or -1
  int worst() const
  {
    return worst_;
  }    // body far outside its groove or without a number in the last step, or -1

 private:
  // What holds lanes is aligned for the widest instructions and has its lanes first.
  struct alignas(32) Group {    // four bodies side by side
    Lane mass, inertia, radius;
    LaneMask used;
    LaneFrame from, base, now;
    Vec3L v_from, w_from, v_base, w_base, v, w, v_first;
    Lane turn = {};      // rad, base to now
    Lane turned = {};    // rad, from to base
    Lane A[36], rhs[6], link[2][6];
    Lane spring = {}, damper = {};    // N/m, N s/m, sums over contacts; with dampers_only
    bool spins;
    bool coupled = false;    // to the border
    bool linked = false;
  };
  struct alignas(32) Column {
    Lane a[6];
  };
  struct Track {
    int ring, first, end;
    const RacewayPhysics *physics;
  };    // groups of balls on one raceway
  struct alignas(32) Touch {
    ContactStateT<Lane> state;
    LaneMask live;
  };
  struct alignas(32) Passed {
    LaneFrame frame;
    Vec3L v, w;
  };    // a group between two steps
  struct alignas(32) Look {
    Lane load, h_c, capacitance;
  };
  struct RailTrack {
    int ring, first, end;
    const std::vector<Rail> *rails;
    const std::vector<double> *stiffness;
  };
  struct alignas(32) Ring {
    Vec3L force_lanes, moment_lanes;
    RingProgram program;
    RingPose from, base, now, first;
    double gained[RingProgram::N_DOF] = {};
    int unknown[RingProgram::N_DOF];    // of a free degree of freedom, else -1
    bool loose = false;
    double spring = 0.0;    // N/m, sum over contacts; with dampers_only
    Vec3 force, moment;     // of the contacts: sums of the lanes
  };
  struct Free {
    int ring, dof;
  };

  void place_bodies();
  void find_unknowns();
  bool coast(double h, double s, bool to_end);
  double stability(double h) const;
  bool solve_stage(const Settings &, double h, double s, Outcome &);
  bool move(double h, double s);
  void start_rhs(double h, bool fresh);
  bool forces(double h, bool fresh);
  template <bool film, Friction friction> RACEWAY_INLINE bool grooves(double h, bool fresh);
  void seats(double h, bool fresh);
  bool pockets(double h, bool fresh);
  void border_rhs(double h, double s);
  void factor_groups();
  void factor();
  void solve();
  template <class ColumnOf> void condense_links(ColumnOf column, bool mark);
  double apply(double h);
  void second_base();
  double error(double h, const Settings &) const;
  void add_energy(double weight, double s);
  double stored_energy();
  void look_at_instants();
  void look_at(double s, Look *);

  BearingModel model_;
  std::vector<int> slot_, body_at_;    // of a body; of a slot (group 4 k + lane), -1: padding
  std::vector<Group> groups_;
  std::vector<Track> tracks_;
  std::vector<RailTrack> rail_tracks_;
  std::vector<Touch> touches_;    // track by track
  std::vector<Ring> rings_;
  std::vector<Free> free_;
  std::vector<Column> B_, C_;    // group by group, unknown by unknown
  DenseLU border_;
  std::vector<double> y_, forces_;    // border, links
  LinkChain chain_;
  std::vector<int> touching_, touched_;    // closed pockets now and at the last factorisation
  struct Place {
    double x[3], v[3];
  };
  std::vector<Place> place_;       // lab, by slot; only bodies with pockets
  std::vector<char> in_pocket_;    // groups
  Vec3 centre_;                    // of the turning frames
  bool dampers_only_ = false;
  bool keep_energy_ = false, unknowns_known_ = false;
  double power_lost_ = 0.0;        // W, in contacts, at the last evaluation
  double contact_energy_ = 0.0;    // J
  Energy energy_, pending_;
  int overlinked_ = -1, worst_ = -1;
  struct {
    double h, s0, s1;
  } present_ = {};    // the step not yet accepted
  Instants instants_;
  int next_instant_ = 1;
  std::vector<Passed> passed_;    // groups
  std::vector<Look> looks_;       // instant by instant, then as touches_
  std::vector<int> look_of_;      // of a groove of the model: lanes * touch + lane
};

}    // namespace raceway

#endif
