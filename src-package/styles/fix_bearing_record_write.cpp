// SPDX-License-Identifier: GPL-2.0-or-later
// Samples of all ranks, put together and written.
#include "../ranks/gather.h"
#include "fix_bearing_record.h"

using namespace LAMMPS_NS;

void FixBearingRecord::end_sample(double step)
{
  rows_.end(time_of(step), step);
  if (rows_.full()) flush();
}

// All ranks.
void FixBearingRecord::flush()
{
  const size_t samples = rows_.samples();
  if (samples == 0) return;
  const std::vector<double> &said = rows_.said();
  std::string why;
  if (comm->nprocs == 1) {
    const double *row = said.data(), *const end = row + said.size();
    for (size_t k = 0; why.empty() && k < samples; ++k) {
      bool whole;
      row = file_->take(row, end, whole);
      why = file_->end_sample(row[1], row[2]);
      row += 3;
    }
  } else {
    why = gather(said, samples);
  }
  rows_.clear();
  refuse_write(why);
}

void FixBearingRecord::refuse_write(const std::string &complaint) const
{
  if (!complaint.empty()) BRG_ONE(command_ + ": " + path_ + ": " + complaint);
}

// Merges the data of all ranks for the same samples, on rank 0.
std::string FixBearingRecord::gather(const std::vector<double> &said, size_t samples)
{
  std::vector<double> all;
  std::vector<size_t> begin = bearing::gather_to_first(said, all, world);
  if (!file_) return "";
  const double *rows = all.data();
  const std::vector<size_t> end(begin.begin() + 1, begin.end());
  begin.pop_back();
  std::string why;
  for (size_t k = 0; why.empty() && k < samples; ++k) {
    double time = 0.0, step = 0.0;
    for (size_t p = 0; p < end.size(); ++p) {
      bool whole;
      const double *row = file_->take(rows + begin[p], rows + end[p], whole);
      if (whole) {
        time = row[1];
        step = row[2];
      }
      begin[p] = static_cast<size_t>(row - rows) + 3;
    }
    why = file_->end_sample(time, step);
  }
  return why;
}
