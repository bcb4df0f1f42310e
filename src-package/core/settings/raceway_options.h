// SPDX-License-Identifier: GPL-2.0-or-later
// The keywords that describe a raceway contact: given to pair_style they are the default of every
// raceway, given to pair_coeff they hold for one pair of types.
#ifndef BEARING_RACEWAY_OPTIONS_H
#define BEARING_RACEWAY_OPTIONS_H

#include "../raceway/raceway_physics.h"
#include "arguments.h"

namespace bearing {

// Consume one keyword with its values. False if the next word is none of them.
// with_film: accept the keywords of bearing/ehd (lubricant, film, roughness, floor, damper,
// stribeck).
bool read_raceway_keyword(Arguments &args, bool with_film, raceway::RacewayPhysics &p);

// For error messages.
std::string raceway_keywords(bool with_film);

}    // namespace bearing

#endif
