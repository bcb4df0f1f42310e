// SPDX-License-Identifier: GPL-2.0-or-later
// fix bearing/checkpoint: allows a run to be continued after it has been stopped or killed. Its
// results and files are bitwise identical to those of an uninterrupted run.
//
// The host writes the restart file, during or after a run. This fix adds data that the host does
// not store, namely the lengths of the output files at that step and running sums. A restart file
// is renamed to its final name only when it is complete.
#ifdef FIX_CLASS
FixStyle(bearing/checkpoint,FixBearingCheckpoint)
#else
#ifndef LMP_FIX_BEARING_CHECKPOINT_H
#define LMP_FIX_BEARING_CHECKPOINT_H

#include "bearing_compat.h"
#include "fix_bearing_ring.h"
#include "run_phase.h"
#include "stop_signal.h"

#include <vector>

namespace LAMMPS_NS {

class FixBearingCheckpoint : public Fix, public bearing::WaitsForRun {
 public:
  FixBearingCheckpoint(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void initial_integrate(int) override;
  void end_of_step() override;
  void post_run() override;
  double compute_scalar() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  void settle(const bearing::Sampling &) override;

 private:
  void begin(const bearing::Sampling &) override;
  void write_every(int steps);
  void take_sample();
  void publish();
  void remove_replaced_files();
  void check_files(const std::string &advice);
  void cut_files();
  void watch_files();
  [[noreturn]] void stop();
  void find_ring();
  std::vector<std::string> deck() const;
  void check_deck();

  bearing::StopSignal stop_signal_;
  std::string command_, file_, part_;
  std::string deck_;    // deck() of the run that wrote the restart file, stored until it has been
                        // compared
  int every_restart_ = 0;
  double keep_ = 0.0;    // number of samples between restart files, in run_bearing
  bool resume_ = false, resumed_ = false;
  std::vector<std::string> files_;    // files that grow with every sample
  std::vector<double> length_;        // sizes in bytes at the step of the restart file
  std::vector<double> seen_;          // sizes in bytes at the last sample
  bool last_ = false;                 // also write a restart file at the end of a run
  double samples_ = 0.0;
  std::string ring_id_;    // ID of a fix bearing/ring whose force balance is averaged, or empty
  FixBearingRing *ring_ = nullptr;
  FixBearingRing::Balance sum_;    // over the samples
  // on rank 0: true if the host has written part_, which has not been published yet
  bool written_ = false;
  bool begun_ = false, cut_ = false;
};

}    // namespace LAMMPS_NS

#endif
#endif
