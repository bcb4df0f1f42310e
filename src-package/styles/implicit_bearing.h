// SPDX-License-Identifier: GPL-2.0-or-later
// One bearing (everything that is connected through possible contacts) in the hands of an implicit integrator:
// its state in turning frames, its forces and their derivatives, one Newton step, and the way back.
//
// A step of length h looks for velocities V at its end with  M (V - V_n) = h F(q_n + h V, V)  (backward Euler; q
// and V in each body's turning frame, physics/turning_frame.h). Newton's method starts from V = V_n, so that the
// first correction alone is the linearly implicit Euler step.
//
// Vectors here have the ring axis as their third component: a cyclic change of names when the axis is x or y.
#ifndef BEARING_IMPLICIT_BEARING_H
#define BEARING_IMPLICIT_BEARING_H

#include "../physics/arrow_system.h"
#include "../physics/turning_frame.h"
#include "bearing_parts.h"
#include "fix_bearing_ring.h"

namespace bearing {

class ImplicitBearing : protected LAMMPS_NS::Pointers {
 public:
  // What one Newton correction did, m: largest over balls across the raceways and over the rings.
  struct Correction {
    bool sane = false;     // false: no finite numbers, or a ball far outside its groove
    double size = HUGE_VAL;
  };

  ImplicitBearing(LAMMPS_NS::LAMMPS *lmp, LAMMPS_NS::PairBearingHertz *pair, const PartModel &model);
  int body_count() const { return static_cast<int>(bodies_.size()); }

  void load(const std::vector<BodyState> &, const std::vector<RingFullState> &);
  void store(std::vector<BodyState> &, std::vector<RingFullState> &) const;

  // A step of length h whose end is at the share s (0 to 1) of the host's step.
  void predict(double h, double s);
  Correction correct();
  void accept();

 private:
  using Vec3 = raceway::Vec3;
  struct Body {
    tag_t tag;
    int size;
    double mass, inertia, radius;
    raceway::TurningFrame start, now;
    Vec3 v_start, w_start, v, w;      // in the frames
    Vec3 x_lab, v_lab, w_lab;         // of `now`
  };
  struct Ring {
    LAMMPS_NS::FixBearingRing *fix;                              // null: at rest
    int unknown[LAMMPS_NS::FixBearingRing::N_DOF];                // of a free degree of freedom, else -1
    bool loose;                                                  // some are free
    Vec3 x_start, v_start, w_start;                              // lab names
    LAMMPS_NS::FixBearingState::RingMotion motion_start, motion;
    raceway::RingState now;                                       // names of this class
    Vec3 x_lab, v_lab, w_lab;
    Vec3 force, moment;                                          // on the ring
  };
  struct Free { int ring, dof; double inertia; Vec3 unit; };     // a free degree of freedom
  struct Groove { int body, ring; const raceway::RacewayPhysics *physics; raceway::ContactState state; };

  void add_ring(LAMMPS_NS::FixBearingRing *);
  // lab names -> names of this class, and back
  Vec3 in(const Vec3 &v) const { return axis_ == 2 ? v : axis_ == 0 ? Vec3{v.y, v.z, v.x} : Vec3{v.z, v.x, v.y}; }
  Vec3 out(const Vec3 &v) const { return axis_ == 2 ? v : axis_ == 0 ? Vec3{v.z, v.x, v.y} : Vec3{v.y, v.z, v.x}; }
  Vec3 lab_unit(int dof, const Ring &) const;
  void move();                        // everything to the end of the step with the present velocities
  void move_ring(Ring &);
  void start_system();
  template <bool film, raceway::Friction friction> bool add_grooves();
  bool choose_grooves();
  void add_pockets();
  void add_seats();
  void couple(int body, int ring, const raceway::ContactJacobian &, const Vec3 &lever, double reach);
  Vec3 motion_of(const Free &, const Vec3 &lever) const;

  LAMMPS_NS::PairBearingHertz *pair_;
  int axis_;
  std::vector<Body> bodies_;
  std::vector<Ring> rings_;
  std::vector<Free> free_;
  std::vector<double> gained_;        // velocity of the free degrees of freedom gained in this step
  std::vector<Groove> grooves_;
  std::vector<PartModel::Pocket> pockets_;
  std::vector<PartModel::Seat> seats_;
  raceway::ArrowSystem system_;
  double h_ = 0.0, share_ = 1.0;
  Vec3 centre_;                       // of the turning frames
};

}    // namespace bearing

#endif
