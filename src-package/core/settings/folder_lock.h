// SPDX-License-Identifier: GPL-2.0-or-later
// One writer a folder: two runs that write to the same files spoil both without a word.
#ifndef BEARING_FOLDER_LOCK_H
#define BEARING_FOLDER_LOCK_H

#include <string>

namespace bearing {

struct FolderClaim {
  std::string complaint;    // empty: this process is the only writer until it ends
  std::string warning;      // the file system knows no locks
};

// Claims `folder` for this process, again if it has it already. The lock is on the file `.writer`
// in it, which names the process; the system gives it up when the process ends, however it does.
FolderClaim claim_folder(const std::string &folder);

}    // namespace bearing

#endif
