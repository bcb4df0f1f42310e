// SPDX-License-Identifier: GPL-2.0-or-later
#include "netcdf_file.h"

#include <cerrno>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace bearing {

namespace {

constexpr size_t count_at = NetcdfHeader::count_at;
constexpr double between_counts = 0.2;         // s, interval between updates of the count
constexpr size_t most_records = 0x7fffffff;    // the header stores a signed number

double now()
{
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

// Writes all n bytes, even if the system splits the write.
std::string write_all(int file, const void *from, size_t n, off_t at)
{
  const char *bytes = static_cast<const char *>(from);
  while (n > 0) {
    const ssize_t done = pwrite(file, bytes, n, at);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return strerror(done < 0 ? errno : ENOSPC);
    bytes += done;
    at += done;
    n -= done;
  }
  return "";
}

}    // namespace

NetcdfFile::~NetcdfFile() { close(); }

std::string NetcdfFile::open(const std::string &path, const NetcdfHeader &header, size_t batch)
{
  header_ = header;
  head_ = header.bytes();
  batch_ = batch;
  filled_ = sending_ = written_ = countable_ = 0;
  blank_ = header.blank_record();
  buffer_.reset(new unsigned char[header.record_bytes() * batch]);
  sent_.reset(new unsigned char[header.record_bytes() * batch]);
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) return strerror(errno);
  // some file systems do not support locks, which is no reason to reject the file
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    return leave("another run is writing it");
  return "";
}

// Closes a file that must not be written to, without changing it.
std::string NetcdfFile::leave(const std::string &why)
{
  ::close(file_);
  file_ = -1;
  return why;
}

std::string NetcdfFile::create(const std::string &path, const NetcdfHeader &header, size_t batch)
{
  std::string why = open(path, header, batch);
  if (!why.empty()) return why;
  if (ftruncate(file_, 0) != 0) return leave(strerror(errno));
  why = write_all(file_, header.bytes().data(), header.bytes().size(), 0);
  return why.empty() ? why : leave(why);
}

std::string NetcdfFile::go_on(const std::string &path, const NetcdfHeader &header, size_t batch,
                              size_t records, int changing)
{
  std::string why = open(path, header, batch);
  if (!why.empty()) return why;
  const std::string &want = header.bytes();
  std::string have(want.size(), '\0');
  if (pread(file_, &have[0], have.size(), 0) != static_cast<ssize_t>(have.size()))
    return leave("it has no whole header");
  const size_t at = header.variable(changing).at;
  have.replace(count_at, 4, want, count_at, 4);
  have.replace(at, 4, want, at, 4);
  for (size_t a : header.changing()) have.replace(a, 8, want, a, 8);
  header.sum(have);
  if (have != want) return leave("it was written with other settings");
  const off_t length = static_cast<off_t>(want.size() + records * header.record_bytes());
  struct stat s;
  if (fstat(file_, &s) != 0) return leave(strerror(errno));
  if (s.st_size < length)
    return leave("it has fewer than " + std::to_string(records) + " samples, the number it had");
  if (ftruncate(file_, length) != 0) return leave(strerror(errno));
  why = write_head();
  if (!why.empty()) return leave(why);
  written_ = countable_ = records;
  return count(written_);
}

unsigned char *NetcdfFile::start_record()
{
  unsigned char *record = &buffer_[filled_ * header_.record_bytes()];
  memcpy(record, blank_.data(), blank_.size());
  ++filled_;
  return record;
}

// The system takes as long to copy a batch as the run takes to compute it, so a separate thread
// waits for the write.
std::string NetcdfFile::flush()
{
  const std::string why = wait();
  if (!why.empty() || filled_ == 0) return why;
  if (written_ + filled_ > most_records) return "it is full: 2147483647 samples";
  std::swap(buffer_, sent_);
  const size_t bytes = filled_ * header_.record_bytes();
  const off_t at = static_cast<off_t>(header_.bytes().size() + written_ * header_.record_bytes());
  sending_ = filled_;
  filled_ = 0;
  const auto write = [this, bytes, at, first = written_] {
    const size_t one = header_.record_bytes();
    for (size_t k = 0; k < bytes / one; ++k) header_.sum(&sent_[k * one], first + k);
    return write_all(file_, sent_.get(), bytes, at);
  };
  try {
    writing_ = std::async(std::launch::async, write);
  } catch (const std::system_error &) {    // there is no thread available
    writing_ = std::async(std::launch::deferred, write);
  }
  return "";
}

// Waits until the batch that was sent last has been written.
std::string NetcdfFile::wait()
{
  if (!writing_.valid()) return "";
  const std::string why = writing_.get();
  if (!why.empty()) return why;
  written_ += sending_;
  sending_ = 0;
  const double t = now();
  if (t - counted_at_ < between_counts) return "";
  counted_at_ = t;
  const size_t then = countable_;
  countable_ = written_;
  return count(then);
}

std::string NetcdfFile::hand_over()
{
  std::string why = flush();
  if (why.empty()) why = wait();
  return why.empty() ? count(written_) : why;
}

std::string NetcdfFile::settle()
{
  const std::string why = hand_over();
  return why.empty() && fsync(file_) != 0 ? strerror(errno) : why;
}

std::string NetcdfFile::close()
{
  if (file_ < 0) return "";
  std::string why = hand_over();
  if (::close(file_) != 0 && why.empty()) why = strerror(errno);
  file_ = -1;
  return why;
}

std::string NetcdfFile::put_fixed(int variable, double value)
{
  const NetcdfHeader::Variable &v = header_.variable(variable);
  put_netcdf(reinterpret_cast<unsigned char *>(&head_[v.at]), v.type, &value, 1);
  header_.sum(head_);
  return write_head();
}

std::string NetcdfFile::write_head()
{
  constexpr size_t at = count_at + 4;
  return write_all(file_, &head_[at], head_.size() - at, at);
}

std::string NetcdfFile::count(size_t records)
{
  unsigned char bytes[4];
  for (int k = 0; k < 4; ++k) bytes[k] = static_cast<unsigned char>(records >> (24 - 8 * k));
  return write_all(file_, bytes, 4, count_at);
}

}    // namespace bearing
