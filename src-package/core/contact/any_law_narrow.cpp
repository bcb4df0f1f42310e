// SPDX-License-Identifier: GPL-2.0-or-later
// The same laws, compiled for processors without AVX2.
#include "../numbers/lane.h"

#ifdef RACEWAY_TWO_TARGETS    // otherwise any_law.cpp covers the only target
#define RACEWAY_ONE_TARGET 1
#include "any_law_parts.h"

namespace raceway {

const LawFunctions narrow_law = law_functions(Parts());

}    // namespace raceway
#endif
