// SPDX-License-Identifier: GPL-2.0-or-later
// Output files on the disk. The hosts do not check whether their writes succeed.
#ifndef RACEWAY_DISK_H
#define RACEWAY_DISK_H

#include <string>

namespace bearing {

double file_size(const std::string &file);    // bytes; -1 without such a file

// Reason why the disk is full; empty if another 64 kB can be written beside `file`.
std::string disk_is_full(const std::string &file);

// Flushes `file` to the disk; true if that succeeded.
bool flush_to_disk(const std::string &file);

}    // namespace bearing

#endif
