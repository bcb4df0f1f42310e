// SPDX-License-Identifier: GPL-2.0-or-later
// The solver of fix bearing/implicit, its settings and the bearings at home on this rank: included
// by the sources of that fix only, so that no other style depends on them.
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
  double step;                              // s, next substep requested by the step control
  raceway::BearingStep::Outcome outcome;    // of the last substep that was tried
};

struct FixBearingImplicit::Solver {
  raceway::BearingStep::Settings settings;
  raceway::BearingStep::Energy energy;    // of bearings of earlier neighbour builds
  bearing::BearingParts bearings;
  std::vector<Part> parts;    // one per bearing at home on this rank
  std::vector<std::unique_ptr<raceway::BearingStep>> steps;
  // Contacts of an instant. For one reader they reuse one buffer, which stays in the caches. For
  // several they are kept for a step: by instant, then by bearing.
  struct Unpacked {
    bigint step = -1;
    std::vector<raceway::BearingInstants::Contact> contacts;
  };
  std::vector<Unpacked> unpacked;
};

}    // namespace LAMMPS_NS

#endif
