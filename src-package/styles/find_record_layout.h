// SPDX-License-Identifier: GPL-2.0-or-later
// Determines the layout of the record for the bearings in a group. It is the same on all ranks.
#pragma once

#include "../core/record/record_layout.h"
#include "bearing_compat.h"

namespace LAMMPS_NS {
class PairBearingHertz;
}

namespace bearing {

struct BearingSources;

// Returns the data of this rank from which the bearings are assembled (ranks/home_bearings.h).
BearingSources sources_of(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &);

// Must be called after the forces have been computed. Stops with an error that names `command` if
// an atom of the group does not belong to any bearing, or if a ball runs on two raceways of the
// same side.
RecordLayout find_record_layout(LAMMPS_NS::LAMMPS *, LAMMPS_NS::PairBearingHertz &, int groupbit,
                                const std::string &command);

// Returns the atom type of the balls of each bearing of a record. Must be called on all ranks.
std::vector<int> ball_types(LAMMPS_NS::LAMMPS *, const RecordLayout &);

}    // namespace bearing
