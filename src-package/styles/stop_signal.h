// SPDX-License-Identifier: GPL-2.0-or-later
// SIGTERM, SIGINT and SIGUSR1 request that a run end after a complete step. If a file exceeds the
// size limit, the run stops with an error message instead of being ended by SIGXFSZ.
#pragma once

namespace bearing {

// Prevents these signals from ending the process while an object of this class exists.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal &) = delete;
  StopSignal &operator=(const StopSignal &) = delete;

  static int caught();            // number of the last signal, or 0 if there was none
  static void set(int signal);    // sets the signal on which all ranks agreed
};

}    // namespace bearing
