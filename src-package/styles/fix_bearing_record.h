// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/record: writes evenly spaced samples of all data of the bearings in a group to one
// netCDF file in a folder (core/record/record_file.h).
//
// At the end of a step, every rank samples the atoms that it owns; within a step, it samples the
// bearings whose home it is (core/record/record_rows.h). The rows of a batch of samples are sent
// together to rank 0, which sorts them, sums over bearings and writes them. The restart file stores
// the length of the record. A continued run truncates the record to that length and then writes the
// same bytes as an uninterrupted run.
#ifdef FIX_CLASS
FixStyle(bearing/record,FixBearingRecord)
#else
#ifndef LMP_FIX_BEARING_RECORD_H
#define LMP_FIX_BEARING_RECORD_H

#include "../contacts/instants.h"
#include "../contacts/tag_set.h"
#include "../core/figures/contact_reader.h"
#include "../core/record/record_rows.h"
#include "bearing_compat.h"
#include "run_phase.h"

#include <memory>

namespace LAMMPS_NS {

class FixBearingRecord : public Fix, public bearing::WaitsForRun {
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

  // Number of samples per ball pass requested from run_bearing; 0 if samples are N steps apart
  // instead.
  double samples_a_pass() const { return a_pass_; }
  int within_asked() const { return within_; }    // 0 if it is chosen by run_bearing
  // Stores a number of samples per ball pass that differs from the requested number.
  void set_samples_a_pass(double number) { a_pass_ = number; }
  // Adds an attribute to the record's header. If `changes` is true, its value may change when the
  // run is continued.
  void note(bearing::NetcdfHeader::Attribute, bool changes = false);

 private:
  void begin(const bearing::Sampling &) override;
  void read_rate(bearing::Arguments &);
  void read_options(bearing::Arguments &);
  void begin_dumps();
  void check_path();
  void check_finished();
  void open();
  void find_integrators();
  void find_heats();
  void keep_oil();
  void keep_commands();
  void check_time_step() const;
  void check_step() const;
  void check_flaws() const;
  void sample(bool between);
  void sample_instants();
  void sample_contacts();
  void sample_gap(int ball, const bearing::ContactView &);
  void sample_cage();
  void sample_parts();
  void end_sample(double step);
  void flush();
  std::string gather(const std::vector<double> &said, size_t samples);
  void refuse(const std::string &complaint) const;    // error unless `complaint` is empty
  void refuse_write(const std::string &complaint) const;
  double time_of(double step) const;
  struct Spent {
    double wall = 0.0, processor = 0.0;       // s, wall-clock and processor times of this rank
    double steps = 0.0, evaluations = 0.0;    // work of the integrator per bearing
  };
  void start_clocks();
  void stop_clocks();
  Spent made() const;    // work done in the current run
  Spent spent_now() const;

  class PairBearingHertz *pair_;
  std::string command_, folder_, path_;
  bool single_ = false, sampled_ = true, motion_ = true, overwrite_ = false;
  bearing::NetcdfHeader::Attributes notes_, about_;    // attributes from the command; all
                                                       // attributes, including derived ones
  bearing::ContactSelection columns_;
  bearing::ContactContext context_;
  bool dumps_ = false;
  int within_ = 1;                                         // samples per step, of which the last is
                                                           // at its end
  double a_pass_ = 0.0;                                    // number of samples per ball pass, or 0
  bool allowed_ = false;                                   // true if the folder may be overwritten
  std::vector<class FixBearingImplicit *> integrators_;    // sources of the instants within steps
  std::vector<class FixBearingCage *> cages_;              // of this run
  std::vector<class FixBearingHeat *> heats_;    // one per bearing or null; empty if all are null
  // If there are heats, the header contains the oil with which the record began: the viscosity and
  // the pressure-viscosity coefficient for each bearing, and the commands of the pair style.
  std::vector<double> oil_;
  std::string commands_;
  bearing::TagSet capacitors_;    // balls for which a capacitance is computed

  bool open_ = false;
  std::unique_ptr<bearing::RecordFile> file_;    // on rank 0 only
  bearing::RecordLayout layout_;
  bearing::RecordRows rows_;    // rows of this rank since the last flush
  double samples_ = 0.0;
  double first_step_ = 0.0, start_ = 0.0, last_step_ = -1.0, step_length_ = 0.0;
  double left_ = -1.0;    // last step of the previous run or of the restart file
  bool resumed_ = false, running_ = false;
  bool over_ = false;    // run_bearing has finished its measurement; later runs take no samples
  Spent clocks_;         // clock readings at the start of the current run
  Spent spent_;          // total of the previous runs
};

}    // namespace LAMMPS_NS

#endif
#endif
