// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/record: a folder with everything about the bearings of a group, sampled evenly, in
// one netCDF file (record/record_file.h).
//
// Every rank reports what it owns; reports of a batch of samples go to rank 0 together, which puts
// them in order, sums over bearings and writes. How long the file was is in the restart file: a run
// that goes on cuts the file to that and writes the same bytes.
#ifdef FIX_CLASS
FixStyle(bearing/record,FixBearingRecord)
#else
#ifndef LMP_FIX_BEARING_RECORD_H
#define LMP_FIX_BEARING_RECORD_H

#include "../contacts/contact_reader.h"
#include "../record/record_file.h"

#include <memory>
#include <unordered_map>

namespace LAMMPS_NS {

class FixBearingRecord : public Fix {
 public:
  FixBearingRecord(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup(int) override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  double memory_usage() override;

 private:
  using Kind = bearing::RecordFile::Kind;
  struct Place {
    Kind kind;
    int at;
  };

  void read_options(class bearing::Arguments &);
  void check_path();
  void open();
  bearing::NetcdfHeader::Attributes about() const;
  void add_bearing(bearing::NetcdfHeader::Attributes &) const;
  void sample();
  void report_contacts();
  void report_parts();
  double *row(Kind, int place);
  void end_sample(double step);
  void flush();
  void refuse(const std::string &complaint) const;    // if there is one
  double time_of(double step) const;
  double steps_made() const;
  struct Spent {
    double wall, steps;    // s; of the integrator
  };
  Spent spent_now() const;
  void write_settings(bool done) const;
  bool holds_finished_run() const;

  class PairBearingHertz *pair_;
  std::string command_, folder_, path_;
  bool single_ = false, sampled_ = true, motion_ = true, overwrite_ = false;
  bearing::NetcdfHeader::Attributes notes_, about_;    // given in the command; with what is known
  bearing::ContactSelection columns_;
  bearing::ContactContext context_;

  bool open_ = false;
  std::unique_ptr<bearing::RecordFile> file_;    // of rank 0
  bearing::RecordLayout layout_;
  std::vector<Place> places_;    // by tag
  size_t widths_[4] = {};
  size_t batch_ = 1, in_batch_ = 0;
  std::vector<double> said_;                  // rows of this rank, since the last flush
  std::vector<bearing::BallShare> shares_;    // by ball, of the present sample
  double samples_ = 0.0;
  double first_step_ = 0.0, start_ = 0.0, last_step_ = -1.0, step_length_ = 0.0;
  bool resumed_ = false, running_ = false;
  double began_ = 0.0;          // s, wall time at the start of the present run
  Spent spent_ = {0.0, 0.0};    // in the runs before it
};

}    // namespace LAMMPS_NS

#endif
#endif
