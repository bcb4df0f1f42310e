// SPDX-License-Identifier: GPL-2.0-or-later
// Records the words of the commands that define the fixes and bearings of a deck, and checksums of
// the files that these commands read. Both are recorded by Arguments, so that a continued run can
// be compared with its restart file. This does not depend on the host.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

// Records the words of a command. For a fix, only the last command is recorded, whereas several
// create_bearing commands are recorded as one checksum. Paths and the options for continuing a run
// are omitted.
void note_words(const LAMMPS_NS::LAMMPS *, const std::string &command,
                const std::vector<std::string> &words);
void note_file(const LAMMPS_NS::LAMMPS *, const std::string &command, const std::string &content);

// Returns the recorded words of a command on one line, or an empty string if the command was not
// recorded.
std::string noted_words(const LAMMPS_NS::LAMMPS *, const std::string &command);

}    // namespace bearing
