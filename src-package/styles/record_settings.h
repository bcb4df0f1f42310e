// SPDX-License-Identifier: GPL-2.0-or-later
// Metadata of a run in a record: attributes of the file, and run.yaml for people and scripts.
#pragma once

#include "../core/record/netcdf_header.h"
#include "../core/record/record_layout.h"
#include "bearing_compat.h"

#include <string>

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

struct RunTimes {
  double sample, start;    // s, time between samples and time of the first sample
};

// Returns the tag of the ring and the words of its fix bearing/profile for every profile of a ring
// in the record. Entries are separated by "; ". Must be called on all ranks.
std::string flaws_of(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &, const RecordLayout &);

// Returns the notes given in the deck, the data of the bearing if there is only one, the name of
// the host, the commands of the pair style, and the flaws.
NetcdfHeader::Attributes record_settings(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &,
                                         const RecordLayout &,
                                         const NetcdfHeader::Attributes &notes, const RunTimes &);

// Writes the given attributes and the numbers in `more` to run.yaml in the folder. Returns an error
// message, or an empty string on success.
std::string write_run_yaml(const std::string &folder, const NetcdfHeader::Attributes &,
                           const NetcdfHeader::Attributes &more);

bool holds_finished_run(const std::string &folder);

}    // namespace bearing
