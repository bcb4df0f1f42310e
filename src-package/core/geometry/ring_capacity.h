// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "../laws/heat.h"
#include "groove.h"

namespace raceway {

// Returns the heat capacity of a ring (J/K). The ring is a cylinder of the given width (m) between
// the diameters (m) of its seat and its shoulders, minus the groove.
inline double ring_capacity(const Groove &groove, double seat, double shoulder, double width)
{
  const bool inner = groove.side == Side::inner;
  const double pi = 3.14159265358979323846, r = groove.groove_radius,
               depth = inner ? 0.5 * shoulder - groove.raceway_radius
                             : groove.raceway_radius - 0.5 * shoulder,
               left = r - depth, half = std::sqrt(r * r - left * left),
               area = r * r * std::acos(left / r) - left * half,
               centroid = 2.0 / 3.0 * half * half * half / area,
               at = groove.centre_circle() + (inner ? -centroid : centroid),
               whole = 0.25 * pi * width * std::fabs(shoulder * shoulder - seat * seat);
  return steel_density * steel_heat * (whole - 2.0 * pi * at * area);
}

}    // namespace raceway
