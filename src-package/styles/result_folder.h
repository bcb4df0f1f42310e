// SPDX-License-Identifier: GPL-2.0-or-later
// Checks of the folder of a run before anything runs: can it be written, is another run writing to
// it, does it hold a finished run, is its restart file whole and of this host. Collective.
#ifndef BEARING_RESULT_FOLDER_H
#define BEARING_RESULT_FOLDER_H

#include "../core/settings/arguments.h"
#include "bearing_compat.h"

namespace bearing {

// Makes the folder and its parents and claims it for this process (core/settings/folder_lock.h).
// Errors name the command of `args`.
void claim_result_folder(LAMMPS_NS::LAMMPS *, const Arguments &args, const std::string &folder);

struct ResumeRequest {
  std::string file;          // restart file
  bool resume, overwrite;    // go on from it; a finished run beside it may go
};

// True if the run goes on from the file. Says so, or that there is none.
bool goes_on(LAMMPS_NS::LAMMPS *, const Arguments &args, const ResumeRequest &);

}    // namespace bearing

#endif
