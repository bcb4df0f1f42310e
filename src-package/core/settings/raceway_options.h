// SPDX-License-Identifier: GPL-2.0-or-later
// Reads the keywords for a raceway contact. In pair_style they set the defaults for all raceways;
// in pair_coeff they apply to one pair of types.
#pragma once

#include "../raceway/raceway_physics.h"
#include "arguments.h"

namespace bearing {

// Reads one keyword with its values. Returns false if the next word is not such a keyword. If
// `with_film` is true, the keywords of bearing/ehd (lubricant, film, roughness, floor, damper,
// stribeck) are also accepted.
bool read_raceway_keyword(Arguments &args, bool with_film, raceway::RacewayPhysics &p);

}    // namespace bearing
