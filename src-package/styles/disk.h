// SPDX-License-Identifier: GPL-2.0-or-later
// Checks that output files are on the disk, because the hosts do not check whether their writes
// succeed.
#pragma once

#include <string>

namespace bearing {

double file_size(const std::string &file);    // size in bytes; -1 if the file does not exist

// Returns an empty string if another 64 kB can be written to the folder of `file`, and otherwise
// the reason why this is not possible.
std::string disk_is_full(const std::string &file);

// Flushes `file` to the disk and returns true on success.
bool flush_to_disk(const std::string &file);

// Flushes `file` to the disk. Returns an empty string if it could have been 64 kB longer, and
// otherwise the reason why not.
std::string flush_with_room(const std::string &file);

}    // namespace bearing
