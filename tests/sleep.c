// SPDX-License-Identifier: GPL-2.0-or-later
// The tests preload this library: a rank that would yield its core while it waits for a message sleeps instead.
#include <time.h>

int sched_yield(void)
{
  struct timespec short_time = {0, 20000};
  return nanosleep(&short_time, 0);
}

// LIGGGHTS lets a partition sleep for 100 s if another partition holds the file with the next point.
unsigned sleep(unsigned seconds)
{
  struct timespec time = {seconds < 2 ? (time_t)seconds : 0, seconds < 2 ? 0 : 1000000};
  nanosleep(&time, 0);
  return 0;
}
