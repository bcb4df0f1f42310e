// SPDX-License-Identifier: GPL-2.0-or-later
// Checksum of a whole restart file, at a position reserved in it by fix bearing/checkpoint.
//
// The host's format has no checksum: a flipped bit would give another bearing. The position holds
// `mark` and eight characters; the checksum (core/numbers/checksum.h) covers the file with zeros in
// place of these eight characters.
#ifndef BEARING_RESTART_SUM_H
#define BEARING_RESTART_SUM_H

#include <string>

namespace bearing {

// For write_restart(): placeholder for the sum.
std::string empty_sum();

// Writes the checksum into a complete file. False without a placeholder or if writing fails.
bool write_sum(const std::string &file);

// True if the sum is right; false also if the file cannot be read or has no position for the sum.
bool has_right_sum(const std::string &file);

}    // namespace bearing

#endif
