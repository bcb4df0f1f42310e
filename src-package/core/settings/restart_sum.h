// SPDX-License-Identifier: GPL-2.0-or-later
// A check sum of a whole restart file, in a place inside it that fix bearing/checkpoint leaves.
//
// The host's format has no sum of its own: a flipped bit gives another bearing. The place is `mark`
// and eight characters; the sum is a CRC-32 (ISO 3309) of the file with zeros for the eight.
#ifndef BEARING_RESTART_SUM_H
#define BEARING_RESTART_SUM_H

#include <string>

namespace bearing {

// For write_restart(): the bytes of the place, not filled in yet.
std::string empty_sum();

// Fill it in, in a file that is whole. False where there is no such place or it cannot be written.
bool write_sum(const std::string &file);

enum class Sum { right, wrong, none, unreadable };
Sum check_sum(const std::string &file);

}    // namespace bearing

#endif
