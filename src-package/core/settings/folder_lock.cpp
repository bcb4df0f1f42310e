// SPDX-License-Identifier: GPL-2.0-or-later
#include "folder_lock.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace bearing {

namespace {

struct Claim {
  std::string file;
  int descriptor;
  dev_t device;
  ino_t inode;
};

bool same_file(const Claim &claim)
{
  struct stat now;
  return stat(claim.file.c_str(), &now) == 0 && now.st_dev == claim.device &&
         now.st_ino == claim.inode;
}

// Folders claimed by this process. The lock files are removed when the process exits normally. If
// the process is killed, they remain, but are no longer locked.
struct Claims {
  std::vector<Claim> list;
  const pid_t owner = getpid();

  ~Claims()
  {
    if (getpid() != owner) return;    // after a fork, the locks belong to the parent
    for (const Claim &c : list)
      if (same_file(c)) unlink(c.file.c_str());
  }
};

Claims &claims()
{
  static Claims all;
  return all;
}

std::string read_all(int descriptor)
{
  char content[256];
  const ssize_t n = pread(descriptor, content, sizeof content, 0);
  return n > 0 ? std::string(content, n) : "another process";
}

std::string own_name()
{
  char host[128] = "";
  gethostname(host, sizeof host - 1);
  return "process " + std::to_string(getpid()) + " on " + host;
}

bool write_all(int descriptor, const std::string &content)
{
  errno = ENOSPC;    // the system does not report a short write as an error
  return ftruncate(descriptor, 0) == 0 && pwrite(descriptor, content.data(), content.size(), 0) ==
                                              static_cast<ssize_t>(content.size());
}

}    // namespace

FolderClaim claim_folder(const std::string &folder)
{
  const std::string file = folder + "/.writer";
  auto unwritable = [&folder]() {
    return FolderClaim{"output folder '" + folder + "' is not writable: " + strerror(errno), ""};
  };
  for (;;) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor < 0) return unwritable();
    struct stat is;
    if (fstat(descriptor, &is) != 0) {
      close(descriptor);
      return unwritable();
    }
    const Claim claim = {file, descriptor, is.st_dev, is.st_ino};
    for (const Claim &c : claims().list)
      if (c.device == claim.device && c.inode == claim.inode) {
        close(descriptor);
        return {};
      }
    FolderClaim result;
    if (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK || errno == EACCES) {
        result.complaint = "output folder '" + folder + "' is in use: " + read_all(descriptor) +
                           " writes there; wait for it to end, or choose another folder";
        close(descriptor);
        return result;
      }
      result.warning = "the file system of '" + folder + "' has no locks (" + strerror(errno) +
                       "): a second run could write there at the same time";
    } else if (!same_file(claim)) {    // in the meantime, the owner of the file has exited and
                                       // removed it
      close(descriptor);
      continue;
    }
    if (!write_all(descriptor, own_name())) {
      const FolderClaim no = unwritable();
      close(descriptor);
      return no;
    }
    claims().list.push_back(claim);
    return result;
  }
}

}    // namespace bearing
