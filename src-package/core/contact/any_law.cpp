// SPDX-License-Identifier: GPL-2.0-or-later
#include "any_law_parts.h"

namespace raceway {

const LawFunctions wide_law = law_functions(Parts());

}    // namespace raceway
