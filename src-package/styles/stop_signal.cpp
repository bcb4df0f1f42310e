// SPDX-License-Identifier: GPL-2.0-or-later
#include "stop_signal.h"

#include <csignal>

namespace bearing {

namespace {

constexpr int stop_signals[] = {SIGTERM, SIGINT, SIGUSR1};
constexpr int n_signals = sizeof stop_signals / sizeof stop_signals[0];
volatile std::sig_atomic_t last_caught = 0;
struct sigaction before[n_signals], before_xfsz;
int objects = 0;

extern "C" void bearing_note_signal(int which) { last_caught = which; }

}    // namespace

StopSignal::StopSignal()
{
  if (objects++) return;
  last_caught = 0;
  struct sigaction note = {}, ignore = {};
  note.sa_handler = bearing_note_signal;
  note.sa_flags = SA_RESTART;
  for (int k = 0; k < n_signals; ++k) sigaction(stop_signals[k], &note, &before[k]);
  ignore.sa_handler = SIG_IGN;
  sigaction(SIGXFSZ, &ignore, &before_xfsz);
}

StopSignal::~StopSignal()
{
  if (--objects) return;
  for (int k = 0; k < n_signals; ++k) sigaction(stop_signals[k], &before[k], nullptr);
  sigaction(SIGXFSZ, &before_xfsz, nullptr);
}

int StopSignal::caught() { return last_caught; }

void StopSignal::set(int signal) { last_caught = signal; }

}    // namespace bearing
