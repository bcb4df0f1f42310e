// SPDX-License-Identifier: GPL-2.0-or-later
// Combines and writes the samples of all ranks.
#include "../ranks/gather.h"
#include "fix_bearing_heat.h"
#include "fix_bearing_record.h"

using namespace LAMMPS_NS;

void FixBearingRecord::end_sample(double step)
{
  std::vector<double> temperatures;
  for (const FixBearingHeat *f : heats_)
    if (f)
      for (const double t : f->temperatures()) temperatures.push_back(t);
    else temperatures.insert(temperatures.end(), bearing::RecordFile::TEMPERATURES, NAN);
  rows_.end(time_of(step), step, temperatures);
  if (rows_.full()) flush();
}

// Sends the rows of all ranks to rank 0, which writes them. Must be called on all ranks.
void FixBearingRecord::flush()
{
  const size_t samples = rows_.samples();
  if (samples == 0) return;
  const std::vector<double> &said = rows_.said();
  std::string why;
  if (comm->nprocs == 1) {
    const double *row = said.data(), *const end = row + said.size();
    const size_t end_row = 1 + file_->width(bearing::RecordFile::END);
    for (size_t k = 0; why.empty() && k < samples; ++k) {
      bool whole;
      row = file_->take(row, end, whole);
      why = file_->end_sample(row);
      row += end_row;
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

// Combines the rows of all ranks that belong to the same samples. Called on rank 0 only.
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
    const double *last = nullptr;    // last row of the sample
    for (size_t p = 0; p < end.size(); ++p) {
      bool whole;
      const double *row = file_->take(rows + begin[p], rows + end[p], whole);
      if (whole) last = row;
      begin[p] = static_cast<size_t>(row - rows) + 1 + file_->width(bearing::RecordFile::END);
    }
    if (last) why = file_->end_sample(last);
  }
  return why;
}
