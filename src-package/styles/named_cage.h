// SPDX-License-Identifier: GPL-2.0-or-later
// The one-piece cage of a named bearing and its data, some of which are estimated.
#pragma once

#include "../core/settings/cage_settings.h"
#include "named_bearing.h"

namespace bearing {

// Returns the settings of the cage, which are derived from the words of fix bearing/cage/ring NAME
// [cage_play J] [cage_across J] [cage_mass M] [cage_young E] [cage_poisson NU] [cage_friction MU]
// [cage_filled X] [cage_guide balls|inner|outer] [cage_land R] [cage_clearance C] [cage_width B]
// [cage_without PART+...] (friction, shear, film, land, churning). The play is estimated as
// `usual_play` times the ball diameter (docs/cage). The mass is estimated as that of a pressed
// steel cage, which is 10 g in a 6205 and scaled in proportion to D^2 d_m. The cage moves in a
// plane if all rings do.
CageSettings named_cage(LAMMPS_NS::LAMMPS *, Arguments &, const NamedBearing &);

}    // namespace bearing
