// SPDX-License-Identifier: GPL-2.0-or-later
// Attributes of a record of bearings with names: data and loads as the deck's commands have them,
// and the variables with which a deck runs again.
#ifndef BEARING_DECK_NOTES_H
#define BEARING_DECK_NOTES_H

#include "record_settings.h"

namespace bearing {

// Adds those that `to` does not have yet; none without a bearing with a name. Collective.
void add_deck_notes(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &, double within,
                    NetcdfHeader::Attributes &to);

// A line for each bearing with a name: its data and the permittivity of its oil, without paths.
std::vector<std::string> data_lines(LAMMPS_NS::LAMMPS *);

}    // namespace bearing

#endif
