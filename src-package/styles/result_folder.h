// SPDX-License-Identifier: GPL-2.0-or-later
// Checks the folder of a run before the run starts: whether it is writable, whether another run is
// writing to it, whether it contains a finished run, and whether its restart file is intact and was
// written by this host. All functions must be called on all ranks.
#pragma once

#include "../core/settings/arguments.h"
#include "bearing_compat.h"

namespace bearing {

// Creates the folder and its parents and claims it for this process (core/settings/folder_lock.h).
// Error messages contain the name of the command in `args`.
void claim_result_folder(LAMMPS_NS::LAMMPS *, const Arguments &args, const std::string &folder);

struct ResumeRequest {
  std::string file;          // restart file
  bool resume, overwrite;    // continue from `file`; a finished run in its folder may be removed
};

// Returns true if the run continues from the file. Prints a message that the run continues or that
// the file is missing.
bool goes_on(LAMMPS_NS::LAMMPS *, const Arguments &args, const ResumeRequest &);

}    // namespace bearing
