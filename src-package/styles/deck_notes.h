// SPDX-License-Identifier: GPL-2.0-or-later
// Attributes of a record of named bearings: data and loads as given to the deck's commands, and the
// variables with which the run of a deck can be repeated.
#ifndef BEARING_DECK_NOTES_H
#define BEARING_DECK_NOTES_H

#include "record_settings.h"

namespace bearing {

// Adds the attributes that `to` lacks; adds none if no bearing has a name. Collective.
void add_deck_notes(LAMMPS_NS::LAMMPS *, const LAMMPS_NS::PairBearingHertz &, const RecordLayout &,
                    double within, NetcdfHeader::Attributes &to);

// One line for each named bearing: its data and the permittivity of its oil, without paths.
std::vector<std::string> data_lines(LAMMPS_NS::LAMMPS *);

}    // namespace bearing

#endif
