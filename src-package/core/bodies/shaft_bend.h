// SPDX-License-Identifier: GPL-2.0-or-later
// A flexible shaft in the implicit step. Its modes are coordinates in addition to those of the
// rigid shaft.
#pragma once

#include "shaft_modes.h"

namespace raceway {

// Modal loads over the host's step, analogous to the loads of RingProgram on the rigid shaft.
struct BendProgram {
  std::vector<double> load[2];         // modal loads (N) for each mode in both planes, at the start
                                       // and the end of the step, before the ramp is applied
  std::vector<Unbalance> unbalance;    // for each mode in one plane
  std::vector<double> centre;          // for each mode, displacement of the centre, needed for a
                                       // rotating force

  // Computes the modal forces (N) at the fraction s of the host's step and writes them to `of`,
  // which is reused.
  void forces(const RingProgram &shaft, double s, double angle, std::vector<double> &of) const
  {
    const size_t n = unbalance.size();
    of.resize(2 * n);
    Vec3 turning;
    if (shaft.turning.size != 0.0)
      turning = across_at(shaft.turning.speed * shaft.age_at(s) + shaft.turning.phase) *
                shaft.turning.size;
    const double share = shaft.share_of_load(s);
    for (size_t k = 0; k < n; ++k) {
      const Vec3 out =
          unbalance[k].moment == 0.0 ? Vec3() : shaft.unbalance_force(unbalance[k], s, angle);
      const double steady = load[0][k] + (load[1][k] - load[0][k]) * s,
                   other = load[0][n + k] + (load[1][n + k] - load[0][n + k]) * s;
      of[k] = share * (steady + centre[k] * turning.x) + out.x;
      of[n + k] = share * (other + centre[k] * turning.y) + out.y;
    }
  }
};

struct ShaftBend {
  struct Seat {
    int ring, column;    // column: first of the ring's columns in the linear system
    double at;           // m, from the centre
    const ShaftModes::Station *station;
  };
  const ShaftModes *modes = nullptr;
  const ShaftModes::Station *centre = nullptr;    // centre of mass
  int shaft = -1;                                 // index in BearingBodies::rings
  int mode = -1;                                  // index of the first mode's coordinate
  std::vector<Seat> seats;
  BendProgram program;
  BendState from, base, now, first, end;
  std::vector<double> gained;      // m/s, change of modal velocities since the base
  std::vector<double> contacts;    // N, modal forces due to the bearings

  int size() const { return 2 * modes->size(); }    // number of unknowns
  // Returns the pose of the centre of mass including the deflection; supports act there.
  RingPose bent_centre(const RingPose &shaft) const
  {
    return carried(shaft, 0.0, shaft.origin, Deflection(*centre, now));
  }
  // Return modal forces, N. loads() returns those due to the loads alone, and forces() those due to
  // contacts, loads, supports, stiffness, damping and the spin of the rigid shaft. The results are
  // valid until the next call, because their memory is reused.
  const std::vector<double> &loads(const RingProgram &, const RingPose &shaft, double s);
  const std::vector<double> &forces(const RingProgram &, const RingPose &shaft, double s);
  void start() { base = now = from; }
  void move(double h, double s);
  void second_base(double beyond);
  void accept() { from = now; }
  void keep() { end = now; }
  void put_back() { now = end; }
  // Sets `now` to the state at the fraction s of a step of h seconds that ends at `end`.
  void between(double h, double s);

 private:
  std::vector<double> loads_, forces_;
};

}    // namespace raceway
