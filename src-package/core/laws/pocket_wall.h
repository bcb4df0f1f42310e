// SPDX-License-Identifier: GPL-2.0-or-later
// Wall of a cage pocket, modelled as a linear spring, which represents the bending of the bars, and
// a damper whose coefficient increases over the first micrometres of overlap. Multi-body programs
// use the same contact model (IMPACT in ADAMS and MotionSolve, exponent 1).
#pragma once

#include "damped_hertz.h"

#include <cmath>

namespace raceway {

// Overlap at which the damper is fully active, as a fraction of the pocket's half clearance.
constexpr double full_damping = 0.02;

// Computes the force k overlap + (c overlap/whole) overlap_rate, limited to values that are not
// attractive. The damping c is critical, 2 sqrt(k m), and fully active above the overlap `whole`
// (m). k is the stiffness, N/m, and m the reduced mass, kg. Precondition: overlap >= 0.
inline DampedHertz damped_wall(double k, double whole, double overlap, double overlap_rate,
                               double m)
{
  DampedHertz h;
  const double critical = 2.0 * std::sqrt(k * m);
  const bool grows = overlap < whole;
  h.stiffness = k;
  h.damping = grows ? critical * overlap / whole : critical;
  h.force = std::fmax(k * overlap + h.damping * overlap_rate, 0.0);
  h.growth = grows && overlap_rate > 0.0 ? k + critical * overlap_rate / whole : k;
  return h;
}

}    // namespace raceway
