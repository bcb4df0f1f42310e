// SPDX-License-Identifier: GPL-2.0-or-later
// Interface of fixes that wait while run_bearing settles the bearings, and take samples while it
// measures.
#pragma once

#include "../core/settings/arguments.h"

namespace bearing {

// ID of the internal fix that exists while run_bearing runs.
inline constexpr const char *fix_of_run = "RUN_BEARING";

// Samples of a measurement, taken once every `every` host steps or `within` times per step.
struct Sampling {
  int every = 1, within = 1;
};

// Stops with an error if a fix takes samples within steps, but not in every step.
inline void check_within(const Arguments &args, int within, int every)
{
  if (within > 1 && every != 1)
    args.fail("'within' takes samples evenly within every step: N must be 1, not " +
              std::to_string(every));
}

class WaitsForRun {
 public:
  bool waits() const { return waits_; }
  // Called before settling if the steps are already known.
  virtual void settle(const Sampling &) {}
  // Called when run_bearing has settled the bearings, before the set-up of the run that measures.
  void measure(const Sampling &sampling)
  {
    waits_ = false;
    begin(sampling);
  }

 protected:
  ~WaitsForRun() = default;
  void wait() { waits_ = true; }
  virtual void begin(const Sampling &) = 0;
  // Stops with an error if a run was started by the host's own command, because this fix would
  // never take a sample in such a run.
  void refuse_plain_run(LAMMPS_NS::LAMMPS *, const std::string &command) const;

 private:
  bool waits_ = false;
};

}    // namespace bearing
