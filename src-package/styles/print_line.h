// SPDX-License-Identifier: GPL-2.0-or-later
// Prints a line for the user on the screen and to the log.
#pragma once

#include "bearing_compat.h"

namespace bearing {

// The first rank prints the line and flushes the output, so that a long run shows it at once.
inline void print_line(LAMMPS_NS::LAMMPS *lmp, const std::string &line)
{
  if (lmp->comm->me != 0) return;
  for (FILE *to : {lmp->screen, lmp->logfile})
    if (to) {
      fprintf(to, "%s\n", line.c_str());
      fflush(to);
    }
}

}    // namespace bearing
