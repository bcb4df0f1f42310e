// SPDX-License-Identifier: GPL-2.0-or-later
// Atom number with the integer type of the host, independent of its headers; compat_*.h compare the
// two types.
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
