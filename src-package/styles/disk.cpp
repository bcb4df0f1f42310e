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

// Writes 64 kB to a file from its end on, and flushes it to the disk.
static std::string extend(int fd)
{
  const std::string content(65536, 'x');
  if (lseek(fd, 0, SEEK_END) < 0) return strerror(errno);
  errno = ENOSPC;    // the system does not report a short write as an error
  const auto length = static_cast<ssize_t>(content.size());
  return write(fd, content.data(), content.size()) == length && fsync(fd) == 0 ? ""
                                                                               : strerror(errno);
}

std::string disk_is_full(const std::string &file)
{
  const std::string probe = file + ".probe";
  const int fd = open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  const std::string why = fd < 0 ? strerror(errno) : extend(fd);
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

std::string flush_with_room(const std::string &file)
{
  const double size = file_size(file);
  const int fd = open(file.c_str(), O_WRONLY);
  std::string why = fd < 0 ? strerror(errno) : extend(fd);
  if (fd >= 0 && ftruncate(fd, static_cast<off_t>(size)) != 0 && why.empty()) why = strerror(errno);
  if (fd >= 0) close(fd);
  return why;
}

}    // namespace bearing
