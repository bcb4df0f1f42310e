// SPDX-License-Identifier: GPL-2.0-or-later
// A growing netCDF classic file. Records are written in batches, each with a single write, while
// the next batch is being filled.
//
// The header contains the number of records (4 bytes at offset 4). A reader of a growing file, or
// of a file left by a killed run, sees only complete records, because this count lags behind the
// data. The count is updated a few times per second, to the number of records written at the
// previous update, because a reader that maps the file first and then reads the count must not find
// more records counted than mapped. A file that is cut at the end of a record is valid, so
// truncate() is sufficient to continue a run. The header and the records have checksums
// (netcdf_header.h).
#pragma once

#include "netcdf_header.h"

#include <future>
#include <memory>

namespace bearing {

class NetcdfFile {
 public:
  NetcdfFile() = default;
  ~NetcdfFile();
  NetcdfFile(const NetcdfFile &) = delete;
  NetcdfFile &operator=(const NetcdfFile &) = delete;

  // The functions below return an error message, which is empty on success.

  // Creates or replaces a file. Records follow in batches of `batch` records.
  std::string create(const std::string &path, const NetcdfHeader &, size_t batch);
  // Cuts a file to its first `records` records and continues it. Except for the value of the scalar
  // `changing`, the file must have the same header.
  std::string go_on(const std::string &path, const NetcdfHeader &, size_t batch, size_t records,
                    int changing);

  // Returns a pointer to the bytes of the next record, all of whose values are initially blank.
  unsigned char *start_record();
  void put(int variable, size_t first, const double *values, size_t n)
  {
    const NetcdfHeader::Variable &v = header_.variable(variable);
    const size_t width = v.type == NetcdfHeader::real ? 8 : 4;
    put_netcdf(&buffer_[(filled_ - 1) * header_.record_bytes()] + v.at + width * first, v.type,
               values, n);
  }

  bool full() const { return filled_ == batch_; }
  std::string flush();        // sends the current batch to the system; returns any error that
                              // occurred in the previous batch
  std::string hand_over();    // flushes, waits until the system has received all data, and updates
                              // the count
  std::string settle();       // hands over and waits until everything is on disk
  std::string close();
  std::string put_fixed(int variable, double value);    // writes a scalar that has no time
                                                        // dimension immediately

  size_t records() const { return written_ + sending_ + filled_; }

 private:
  std::string open(const std::string &path, const NetcdfHeader &, size_t batch);
  std::string leave(const std::string &why);
  std::string wait();
  std::string count(size_t records);
  std::string write_head();    // writes the whole header except for the number of records

  NetcdfHeader header_;
  std::string head_;    // current bytes of the header
  std::vector<unsigned char> blank_;
  std::unique_ptr<unsigned char[]> buffer_, sent_;    // not filled with zeros, which takes time
  std::future<std::string> writing_;                  // the pending write of sent_
  size_t batch_ = 1, filled_ = 0, sending_ = 0, written_ = 0, countable_ = 0;
  int file_ = -1;
  double counted_at_ = 0.0;    // s
};

}    // namespace bearing
