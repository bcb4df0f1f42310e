// SPDX-License-Identifier: GPL-2.0-or-later
// The solver of fix bearing/implicit, its settings and the bearings whose home is on this rank.
// Only the sources of that fix include this header, so that no other style depends on it.
#pragma once

#include "../core/step/bearing_integrator.h"
#include "../ranks/home_bearings.h"
#include "fix_bearing_implicit.h"

#include <memory>
#include <vector>

namespace LAMMPS_NS {

constexpr double smallest_step = 1e-12;    // s

struct FixBearingImplicit::OwnBearing {
  raceway::BearingIntegrator *integrator;
  double step;                                    // s, next substep requested by the step control
  raceway::BearingIntegrator::Outcome outcome;    // result of the last attempted substep
};

struct FixBearingImplicit::Solver {
  raceway::BearingIntegrator::Settings settings, fine;    // settings for the current step; settings
                                                          // given in the deck
  raceway::BearingIntegrator::Energy energy;              // totals up to the last neighbour build
  bearing::HomeBearings bearings;
  std::vector<OwnBearing> own;    // one entry per bearing whose home is on this rank
  std::vector<std::unique_ptr<raceway::BearingIntegrator>> integrators;
  // indexed by bearing and by instant; kept between neighbour builds, so that memory is not
  // allocated again
  std::vector<std::vector<raceway::BearingAtInstant>> instants;
};

}    // namespace LAMMPS_NS
