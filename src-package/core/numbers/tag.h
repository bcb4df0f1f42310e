// SPDX-License-Identifier: GPL-2.0-or-later
// Atom ID with the integer type of the host but independent of the host's headers; compat_*.h check
// that both types have the same size.
#ifndef BEARING_TAG_H
#define BEARING_TAG_H

#include <cstdint>

namespace bearing {
#ifdef LAMMPS_BIGBIG
typedef std::int64_t tag_t;
#else
typedef int tag_t;
#endif
}    // namespace bearing

#endif
