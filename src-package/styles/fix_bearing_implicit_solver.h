// SPDX-License-Identifier: GPL-2.0-or-later
// The solver of fix bearing/implicit, its settings and the bearings at home here: for the sources
// of that fix alone, so that no other style depends on them.
#ifndef BEARING_IMPLICIT_SOLVER_H
#define BEARING_IMPLICIT_SOLVER_H

#include "../core/step/bearing_step.h"
#include "../ranks/bearing_parts.h"
#include "fix_bearing_implicit.h"

#include <memory>
#include <vector>

namespace LAMMPS_NS {

constexpr double smallest_step = 1e-12;    // s

struct FixBearingImplicit::Part {
  raceway::BearingStep *bearing;
  double step;                              // s, the control's wish for the next substep
  raceway::BearingStep::Outcome outcome;    // of the last substep that was tried
};

struct FixBearingImplicit::Solver {
  raceway::BearingStep::Settings settings;
  raceway::BearingStep::Energy energy;    // of bearings of earlier neighbour builds
  bearing::BearingParts bearings;
  std::vector<Part> parts;    // one a bearing at home here
  std::vector<std::unique_ptr<raceway::BearingStep>> steps;
  // Contacts of an instant. With one reader they take turns in one place, so that they stay in the
  // caches. With more they are kept for a step: by instant, then by bearing.
  struct Unpacked {
    bigint step = -1;
    std::vector<raceway::BearingInstants::Contact> contacts;
  };
  std::vector<Unpacked> unpacked;
};

}    // namespace LAMMPS_NS

#endif
