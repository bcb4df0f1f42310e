// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/cage/ring: a rigid one-piece cage for each bearing, represented by one atom
// (core/geometry/cage_ring.h). The fix is a fix bearing/ring whose rings are the cages, which move
// freely in space or in a plane. It adds the forces that act in the pockets, at the guiding land
// and due to churning.
#ifdef FIX_CLASS
FixStyle(bearing/cage/ring,FixBearingCageRing)
#else
#ifndef LMP_FIX_BEARING_CAGE_RING_H
#define LMP_FIX_BEARING_CAGE_RING_H

#include "../contacts/cage_pockets.h"
#include "../core/settings/cage_settings.h"
#include "fix_bearing_ring.h"

namespace LAMMPS_NS {

class FixBearingCageRing : public FixBearingRing {
 public:
  FixBearingCageRing(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup_pre_neighbor() override { pre_neighbor(); }
  void pre_neighbor() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  double compute_vector(int) override;

  // Takes the oil of the named bearing, which may change from run to run and during a run.
  void take_oil();

  const bearing::CagePockets &pockets() const { return all_; }
  const bearing::CageSettings &settings() const { return cage_; }    // also valid before a run

 private:
  raceway::CageMotion motion(int i) const;
  void turn_to_balls();
  bool rings_stay_in_plane() const;
  void find_cells();
  void find_lands();
  void check_cells() const;
  void pocket_forces();
  void land_forces();
  [[noreturn]] void left_pocket(const bearing::CagePockets::Cell &, int pocket, double) const;

  std::string bearing_;    // name of the bearing, or empty
  int ball_type_ = 0;
  double ball_radius_ = 0.0;
  bearing::CageSettings cage_;
  bearing::CagePockets all_;
  size_t first_row_ = 0;         // position in the contact table: cells come first, then lands
  double eccentricity_ = 0.0;    // largest value on this rank, relative to the clearance
};

}    // namespace LAMMPS_NS

#endif
#endif
