// SPDX-License-Identifier: GPL-2.0-or-later
// Data of a bearing or an oil as names and values: from a file or a row of a catalogue, with
// the user's own values taking precedence.
#ifndef BEARING_NAMED_DATA_H
#define BEARING_NAMED_DATA_H

#include "data_values.h"

namespace bearing {

// Lines `variable NAME index VALUE` of INPUTS/SORT/NAME, of a row NAME of its tables, or of the
// file NAME if it has a '/'. For each name the first line counts; -var and the deck's own
// `variable` take precedence. Collective.
struct NamedData {
  std::string label;    // for messages
  DataValues::Map values;
  DataValues::Map of_file;             // values of the file alone
  std::vector<std::string> of_deck;    // names that the deck sets
};
NamedData read_data(LAMMPS_NS::LAMMPS *, const Arguments &, const std::string &inputs,
                    const std::string &sort, const std::string &name);

// Data of these kinds that differ from the file's, as NAME=VALUE
std::vector<std::string> given_of(const NamedData &, const std::vector<std::string> &kinds);

// Note to the user about data of the file that the deck replaces; empty if there is none.
std::string note_of_deck(const NamedData &);

// Sets the defaults of the variables of the table that belong to `of`, and checks all of them;
// error if a variable without default is missing. Returns the names of the variables that it set.
std::vector<std::string> check_data(const Arguments &, NamedData &, const std::string &of);

}    // namespace bearing

#endif
