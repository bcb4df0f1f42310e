// SPDX-License-Identifier: GPL-2.0-or-later
// Keywords for a raceway contact: in pair_style they are the default for all raceways, in
// pair_coeff they apply to one pair of types.
#ifndef BEARING_RACEWAY_OPTIONS_H
#define BEARING_RACEWAY_OPTIONS_H

#include "../raceway/raceway_physics.h"
#include "arguments.h"

namespace bearing {

// Reads one keyword with its values. False if the next word is not such a keyword. with_film:
// accept the keywords of bearing/ehd (lubricant, film, roughness, floor, damper, stribeck).
bool read_raceway_keyword(Arguments &args, bool with_film, raceway::RacewayPhysics &p);

// Keywords for error messages.
std::string raceway_keywords(bool with_film);

}    // namespace bearing

#endif
