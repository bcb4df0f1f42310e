// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/verlet: velocity Verlet for the balls and cage balls of a group, using the host's fix
// nve/sphere. The rings of the group are moved by fix bearing/ring.
#ifdef FIX_CLASS
FixStyle(bearing/verlet,FixBearingVerlet)
#else
#ifndef LMP_FIX_BEARING_VERLET_H
#define LMP_FIX_BEARING_VERLET_H

#include "bearing_compat.h"

namespace LAMMPS_NS {

class FixBearingVerlet : public Fix {
 public:
  FixBearingVerlet(class LAMMPS *, int, char **);
  ~FixBearingVerlet() override;
  int setmask() override { return 0; }
  void BRG_AFTER_CREATION() override;    // defines the host's fix
  void init() override;

 private:
  std::string name() const { return std::string(id) + "_BALLS"; }    // name of the group and of the
                                                                     // fix
};

}    // namespace LAMMPS_NS

#endif
#endif
