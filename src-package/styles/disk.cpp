// SPDX-License-Identifier: GPL-2.0-or-later
#include "disk.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bearing {

double file_size(const std::string &file)
{
  struct stat s;
  return stat(file.c_str(), &s) == 0 ? static_cast<double>(s.st_size) : -1.0;
}

std::string disk_is_full(const std::string &file)
{
  const std::string probe = file + ".probe", content(65536, 'x');
  std::string why;
  const int fd = open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (fd < 0) {
    why = strerror(errno);
  } else {
    errno = ENOSPC;    // the system does not report a short write as an error
    if (write(fd, content.data(), content.size()) != static_cast<ssize_t>(content.size()) ||
        fsync(fd) != 0)
      why = strerror(errno);
  }
  if (fd >= 0) close(fd);
  unlink(probe.c_str());
  return why;
}

bool flush_to_disk(const std::string &file)
{
  const int fd = open(file.c_str(), O_RDONLY);
  const bool good = fd >= 0 && fsync(fd) == 0;
  if (fd >= 0) close(fd);
  return good;
}

}    // namespace bearing
