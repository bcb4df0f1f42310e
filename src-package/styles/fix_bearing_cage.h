// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/cage: torus rails that hold the cage balls of a group. The contacts are elastic,
// frictionless and critically damped. The rails are fixed to a ring (usually the outer one) and
// pass their reactions to it.
#ifdef FIX_CLASS
FixStyle(bearing/cage,FixBearingCage)
#else
#ifndef LMP_FIX_BEARING_CAGE_H
#define LMP_FIX_BEARING_CAGE_H

#include "../contacts/cage_rails.h"
#include "bearing_compat.h"

#include <vector>

namespace bearing {
struct NamedBearing;
}

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingCage : public Fix {
 public:
  FixBearingCage(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup_pre_neighbor() override;
  void pre_neighbor() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  double compute_scalar() override;
  double compute_vector(int) override;

  const bearing::CageRails &rails() const { return cage_; }

 private:
  const bearing::NamedBearing *named() const;
  bool expected() const;
  bool holds(int i) const;
  void find_balls();

  PairBearingHertz *pair_;
  int ring_type_ = 0;
  int cage_type_ = 0;    // type of the balls on the rails; 0 if all balls of the group are on them
  bearing::CageRails cage_;
  double tube_ = 1e-3, gap_ = 0.0;
  double young_[2] = {3.3e9, 3.3e9}, poisson_[2] = {0.41, 0.41};    // PA66 on PA66
  bool seats_ = true;    // use the default pair of rails, placed to fit the cage balls
  double pitch_ = 0.0;
  double pocket_ = 0.0;    // m, largest distance of a cage ball from the pitch circle
  // Positions and velocities (radial, axial) of four cage balls relative to the ring, and their
  // masses, radii, rail forces and dissipated powers.
  struct alignas(32) Four {
    raceway::Lane r, z, vr, ve, mass, radius, fr, fe, loss;
    void spare(int first);
  };
  void find_forces();
  void left_pocket(const bearing::CageRails::CageBall &, double off) const;
  std::vector<Four> fours_;
  double force_sum_ = 0.0, force_max_ = 0.0;    // N, sum and maximum on this rank in the last step
};

}    // namespace LAMMPS_NS

#endif
#endif
