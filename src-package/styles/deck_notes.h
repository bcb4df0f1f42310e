// SPDX-License-Identifier: GPL-2.0-or-later
// Creates the attributes of a record of named bearings: the data and loads that were passed to the
// commands of the deck, and the variables with which the deck can be run again.
#pragma once

#include "record_settings.h"

namespace bearing {

// Adds the attributes that `to` does not contain yet, or none if no bearing has a name. Must be
// called on all ranks.
void add_deck_notes(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &, const RecordLayout &,
                    double within, NetcdfHeader::Attributes &to);

// Returns one line for each named bearing, which contains its data and the permittivity of its oil,
// but no paths.
std::vector<std::string> data_lines(LAMMPS_NS::LAMMPS *);

}    // namespace bearing
