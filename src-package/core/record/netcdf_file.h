// SPDX-License-Identifier: GPL-2.0-or-later
// A netCDF classic file that grows: records go to the system a batch at a time, one write each,
// while the next batch fills.
//
// The header counts the records (4 bytes at offset 4). A reader of a growing or a killed file sees
// whole records only: the count follows the writing. It is renewed a few times a second, with what
// was written at the renewal before, because a reader that maps the file first and reads the count
// after must not find more counted than mapped. A file cut behind a record is a good file again:
// going on is a truncate().
#ifndef BEARING_NETCDF_FILE_H
#define BEARING_NETCDF_FILE_H

#include "netcdf_header.h"

#include <future>

namespace bearing {

class NetcdfFile {
 public:
  NetcdfFile() = default;
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile &) = delete;
  NetcdfFile &operator=(const NetcdfFile &) = delete;

  // These return a complaint, empty if all is well.
  // A new file, whatever was there; then records in batches of `batch`.
  std::string create(const std::string &path, const NetcdfHeader &, size_t batch);
  // One of the same header, but for the value of the scalar `changing`, cut to its first `records`.
  std::string go_on(const std::string &path, const NetcdfHeader &, size_t batch, size_t records,
                    int changing);

  // The bytes of the next record, blank at first.
  unsigned char *start_record();
  void put(int variable, size_t first, const double *values, size_t n)
  {
    const NetcdfHeader::Variable &v = header_.variable(variable);
    const size_t width = v.type == NetcdfHeader::real ? 8 : 4;
    put_netcdf(&buffer_[(filled_ - 1) * header_.record_bytes()] + v.at + width * first, v.type,
               values, n);
  }

  bool full() const { return filled_ == batch_; }
  std::string flush();        // send the batch so far; complaints about the one before
  std::string hand_over();    // flush and wait until the system has everything
  std::string settle();       // flush, count everything and wait until it is on the disk
  std::string close();
  std::string put_fixed(int variable, double value);    // a scalar without time, at once

  bool is_open() const { return file_ >= 0; }
  size_t records() const { return written_ + sending_ + filled_; }

 private:
  std::string open(const std::string &path, const NetcdfHeader &, size_t batch);
  std::string leave(const std::string &why);
  std::string wait();
  std::string count(size_t records);

  NetcdfHeader header_;
  std::vector<unsigned char> buffer_, sent_, blank_;
  std::future<std::string> writing_;    // of sent_
  size_t batch_ = 1, filled_ = 0, sending_ = 0, written_ = 0, countable_ = 0;
  int file_ = -1;
  double counted_at_ = 0.0;    // s
};

}    // namespace bearing

#endif
