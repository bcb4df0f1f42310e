// SPDX-License-Identifier: GPL-2.0-or-later
// What a record says of a run beside its samples: as attributes of the file, and for people and
// scripts in run.yaml.
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
  double sample, start;    // s: between samples, of the first one
};

// Every profile of a ring of the record: the ring's tag and the words of the fix bearing/profile,
// with "; " between them. All ranks.
std::string flaws_of(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &, const RecordLayout &);

// The notes of the deck, what is known of the bearing if there is one, the host, the commands of
// the pair style and the flaws.
NetcdfHeader::Attributes record_settings(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &,
                                         const RecordLayout &,
                                         const NetcdfHeader::Attributes &notes, const RunTimes &);

// Writes them to run.yaml in the folder, and `more`, which are numbers. A complaint, or empty.
std::string write_run_yaml(const std::string &folder, const NetcdfHeader::Attributes &,
                           const NetcdfHeader::Attributes &more);

bool holds_finished_run(const std::string &folder);

}    // namespace bearing

#endif
