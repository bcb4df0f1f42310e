// SPDX-License-Identifier: GPL-2.0-or-later
#include "instruction_set.h"

#include "lane.h"

#include <cstdlib>

namespace raceway {

bool wide_lanes()
{
#ifdef RACEWAY_TWO_TARGETS
  static const bool wide =
      __builtin_cpu_supports("avx2") && std::getenv("RACEWAY_NARROW_LANES") == nullptr;
  return wide;
#else
  return true;    // there is only one compilation
#endif
}

}    // namespace raceway
