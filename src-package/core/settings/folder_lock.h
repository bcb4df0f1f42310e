// SPDX-License-Identifier: GPL-2.0-or-later
// Ensures that a folder has only one writer, because two runs that write the same files would
// silently corrupt both.
#pragma once

#include <string>

namespace bearing {

struct FolderClaim {
  std::string complaint;    // empty if this process is the only writer until it ends
  std::string warning;      // set if the file system does not support locks
};

// Claims `folder` for this process. A repeated claim also succeeds. The lock applies to the file
// `.writer` in the folder, which contains the name of the process. The system releases the lock
// regardless of how the process ends.
FolderClaim claim_folder(const std::string &folder);

}    // namespace bearing
