// SPDX-License-Identifier: GPL-2.0-or-later
// SIGTERM, SIGINT and SIGUSR1 ask a run to end after a complete step. Files above the size limit
// cause an error with a message instead of SIGXFSZ.
#ifndef RACEWAY_STOP_SIGNAL_H
#define RACEWAY_STOP_SIGNAL_H

namespace bearing {

// Keeps the signals from ending the process while objects of this class exist.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal &) = delete;
  StopSignal &operator=(const StopSignal &) = delete;

  static int caught();    // number of the last signal; 0: none since the first object was made
  static void set(int signal);    // what all ranks agreed on
};

}    // namespace bearing

#endif
