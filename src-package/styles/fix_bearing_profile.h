// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/profile: what the raceways of the rings of a group depart from their torus by.
#ifdef FIX_CLASS
FixStyle(bearing/profile,FixBearingProfile)
#else
#ifndef LMP_FIX_BEARING_PROFILE_H
#define LMP_FIX_BEARING_PROFILE_H

#include "../physics/contact.h"
#include "../physics/raceway_profile.h"
#include "bearing_compat.h"

#include <string>

namespace bearing {
class Arguments;
}

namespace LAMMPS_NS {

class PairBearingHertz;

class FixBearingProfile : public Fix {
 public:
  FixBearingProfile(class LAMMPS *, int, char **);
  int setmask() override { return 0; }
  void init() override;

  bool departs() const    // from a torus
  {
    return !(shape_.notches.empty() && shape_.waves.empty() && shape_.tables.empty());
  }
  const std::string &said() const { return said_; }    // its keywords and values

  struct Ring {
    bearing::tag_t tag;
    int type, turns_alone;    // 1: it spins, and no fix bearing/ring counts its angle
  };
  std::vector<Ring> rings(PairBearingHertz &) const;    // of the group, of all ranks

 private:
  raceway::NotchShape read_notch(bearing::Arguments &) const;
  raceway::Wave read_wave(bearing::Arguments &) const;
  raceway::PeriodicCurve read_table(bearing::Arguments &) const;
  void check(const raceway::RacewayPhysics &) const;
  void check_pits(bearing::tag_t ring, const raceway::ProfileShape &,
                  const raceway::RacewayPhysics &) const;

  std::string said_;
  int groove_ = 0;
  raceway::ProfileShape shape_;
};

}    // namespace LAMMPS_NS

#endif
#endif
