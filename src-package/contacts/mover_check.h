// SPDX-License-Identifier: GPL-2.0-or-later
// Checks at the start of a run that the fixes of a deck move the atoms of bearings and the grains.
// The hosts do not move atoms that are in the group of no integrator, and do not say so.
#pragma once

#include "../core/settings/pair_coefficients.h"
#include "bearing_compat.h"

#include <functional>

namespace bearing {

// Atoms that lack something, on all ranks.
struct Lacking {
  long count = 0;
  double first = 0.0;    // lowest atom number
};

// Returns the atoms of the given types that no fix moves.
Lacking unmoved(LAMMPS_NS::LAMMPS *, const std::function<bool(int)> &type);

class MoverCheck {
 public:
  // Warns of balls, cage balls and grains that no fix moves or turns, and of grains without
  // contacts, whenever their number has changed. Stops with an error if a fix of the host moves a
  // ring, unless the ring is in the groups `implicit` of the fixes bearing/implicit, which check
  // what else moves their atoms.
  void look(LAMMPS_NS::LAMMPS *, const PairCoefficients &, int implicit);

 private:
  void warn(LAMMPS_NS::LAMMPS *, int which, const Lacking &, const std::string &what,
            const std::string &need);

  long warned_[5] = {};
};

}    // namespace bearing
