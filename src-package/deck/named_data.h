// SPDX-License-Identifier: GPL-2.0-or-later
// Data of a bearing or an oil, stored as names and values. They are read from a file or a row of a
// catalogue, but values given by the user take precedence.
#pragma once

#include "../core/settings/deck_variable_table.h"
#include "data_values.h"

namespace bearing {

// Data read from lines `variable NAME index VALUE` of the file INPUTS/SORT/NAME, from a row NAME of
// the tables in that folder, or from the file NAME if it contains a '/'. If a name occurs more than
// once, the first line is used; -var and the deck's own `variable` commands take precedence. Must
// be called on all ranks.
struct NamedData {
  std::string label;    // for messages
  DataValues::Map values;
  DataValues::Map of_file;             // values from the file alone
  std::vector<std::string> of_deck;    // names that the deck sets
};
NamedData read_data(LAMMPS_NS::LAMMPS *, const Arguments &, const std::string &inputs,
                    const std::string &sort, const std::string &name);

// Returns the data of the given kinds whose values differ from those in the file, as NAME=VALUE.
std::vector<std::string> given_of(const NamedData &, const std::vector<std::string> &kinds);

// Returns a note to the user about data in the file that are replaced by the deck, or an empty
// string if there are none.
std::string note_of_deck(const NamedData &);

// Sets the defaults of the variables in the table that belong to the kind of data `of`, and checks
// all of these variables. Stops with an error if a needed variable is missing. Returns the names of
// the variables that were set.
std::vector<std::string> check_data(const Arguments &, NamedData &, const std::string &of);
// Stops with an error unless the value is in the range of the table. The message names the file if
// the value is from there.
void check_datum(const Arguments &, const NamedData &, const DeckVariable &);

}    // namespace bearing
