// SPDX-License-Identifier: GPL-2.0-or-later
// Integer type for atom IDs. It is the same type as in the host, but does not depend on the host's
// headers; compat_*.h check that the two types have the same size.
#pragma once

#include <cstdint>

namespace bearing {
#ifdef LAMMPS_BIGBIG
typedef std::int64_t tag_t;
#else
typedef int tag_t;
#endif
}    // namespace bearing
