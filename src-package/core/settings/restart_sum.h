// SPDX-License-Identifier: GPL-2.0-or-later
// Checksum of a whole restart file, stored at a position that fix bearing/checkpoint reserves in
// it.
//
// The host's format has no checksum, so a flipped bit would silently change the bearing. The
// reserved position contains `mark` and eight characters. The checksum (core/numbers/checksum.h) is
// computed for the file with zeros in place of these eight characters.
#pragma once

#include <string>

namespace bearing {

// Returns the placeholder for the sum, for use in write_restart().
std::string empty_sum();

// Writes the checksum to a complete file. Returns false if there is no placeholder or if writing
// fails.
bool write_sum(const std::string &file);

// Returns true if the sum is correct, and false if it is not, if the file cannot be read, or if the
// file has no placeholder for the sum.
bool has_right_sum(const std::string &file);

}    // namespace bearing
