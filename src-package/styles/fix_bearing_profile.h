// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/profile: describes how the raceways of the rings in a group deviate from a torus, or
// how the balls in a group deviate from a sphere.
#ifdef FIX_CLASS
FixStyle(bearing/profile,FixBearingProfile)
#else
#ifndef LMP_FIX_BEARING_PROFILE_H
#define LMP_FIX_BEARING_PROFILE_H

#include "../core/raceway/raceway_physics.h"
#include "../core/settings/profile_settings.h"
#include "bearing_compat.h"

#include <string>

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingProfile : public Fix {
 public:
  FixBearingProfile(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void pre_force(int) override;

  bool departs() const { return settings_.departs(); }    // true if the surfaces deviate from a
                                                          // torus or sphere
  bool of_balls() const { return settings_.of_balls; }
  const std::string &said() const { return said_; }    // keywords and values of the command

  struct Flawed {
    bearing::tag_t tag;
    int type, turns_alone;    // turns_alone: 1 if it spins and no fix bearing/ring tracks its angle
  };
  // Returns the balls or rings of the group on all ranks. Stops with an error if there are none.
  std::vector<Flawed> bodies(PairBearingHertz &) const;

 private:
  void add_rings(PairBearingHertz &, const std::vector<FixBearingProfile *> &) const;
  void add_balls(PairBearingHertz &, const std::vector<FixBearingProfile *> &) const;
  void check(const raceway::RacewayPhysics &) const;
  void check_ball(const raceway::RacewayPhysics &) const;
  void check_notch(const raceway::NotchShape &, const char *what, double rolling) const;
  void check_wave(const raceway::Wave &, double radius, double rolling) const;
  void check_apart(bearing::tag_t ball, const raceway::BallShape &, double radius) const;
  void check_pits(bearing::tag_t ring, const raceway::ProfileShape &,
                  const raceway::RacewayPhysics &) const;

  std::string said_;
  bearing::ProfileSettings settings_;
  bool turns_ = false;    // true if this fix rotates the balls for all fixes of this style
};

}    // namespace LAMMPS_NS

#endif
#endif
