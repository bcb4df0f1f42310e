// SPDX-License-Identifier: GPL-2.0-or-later
// Metadata of a run in a record: attributes of the file, and run.yaml for people and scripts.
#ifndef BEARING_RECORD_SETTINGS_H
#define BEARING_RECORD_SETTINGS_H

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

// Returns, for every profile of a ring of the record, the ring's tag and the words of its fix
// bearing/profile. Entries are separated by "; ". Collective.
std::string flaws_of(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &, const RecordLayout &);

// Returns the notes of the deck, the data of the bearing if there is only one, the host, the
// commands of the pair style and the flaws.
NetcdfHeader::Attributes record_settings(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &,
                                         const RecordLayout &,
                                         const NetcdfHeader::Attributes &notes, const RunTimes &);

// Writes these attributes and the numbers in `more` to run.yaml in the folder. Returns an error
// message, or an empty string on success.
std::string write_run_yaml(const std::string &folder, const NetcdfHeader::Attributes &,
                           const NetcdfHeader::Attributes &more);

bool holds_finished_run(const std::string &folder);

}    // namespace bearing

#endif
