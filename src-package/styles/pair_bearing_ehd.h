// SPDX-License-Identifier: GPL-2.0-or-later
// pair_style bearing/ehd: bearing/hertz with an EHD film, film damping, and friction that depends
// on the lambda ratio.
#ifdef PAIR_CLASS
PairStyle(bearing/ehd,PairBearingEHD)
#else
#ifndef LMP_PAIR_BEARING_EHD_H
#define LMP_PAIR_BEARING_EHD_H

#include "pair_bearing_hertz.h"

namespace LAMMPS_NS {

class PairBearingEHD : public PairBearingHertz {
 public:
  explicit PairBearingEHD(class LAMMPS *lmp) : PairBearingHertz(lmp, true) {}
};

}    // namespace LAMMPS_NS

#endif
#endif
