// SPDX-License-Identifier: GPL-2.0-or-later
// The solver of fix bearing/implicit, its settings and the bearings at home here: for the sources of
// that fix alone, so that no other style depends on them.
#ifndef BEARING_IMPLICIT_SOLVER_H
#define BEARING_IMPLICIT_SOLVER_H

#include "../implicit/bearing_step.h"
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
  std::vector<raceway::BearingInstants::Contact> contacts;    // of the instant that is read
};

}    // namespace LAMMPS_NS

#endif
