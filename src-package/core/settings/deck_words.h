// SPDX-License-Identifier: GPL-2.0-or-later
// Words of the fixes and bearings of a deck, and checksums of the files that they read. Arguments
// notes them, for the comparison of a continued run with its restart file. Independent of the host.
#ifndef BEARING_DECK_WORDS_H
#define BEARING_DECK_WORDS_H

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

// A fix is noted anew by its last command; several create_bearing commands are noted by a checksum.
// Paths and words that say whether a run continues are left out.
void note_words(const LAMMPS_NS::LAMMPS *, const std::string &command,
                const std::vector<std::string> &words);
void note_file(const LAMMPS_NS::LAMMPS *, const std::string &command, const std::string &content);

// One line; empty if the command was not noted.
std::string noted_words(const LAMMPS_NS::LAMMPS *, const std::string &command);

}    // namespace bearing

#endif
