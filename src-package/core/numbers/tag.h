// SPDX-License-Identifier: GPL-2.0-or-later
// Number of an atom, as the host counts them: known without its headers, which compat_*.h compare.
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
