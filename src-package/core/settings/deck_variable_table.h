// SPDX-License-Identifier: GPL-2.0-or-later
// A table of all deck variables with their names, defaults, units, ranges and meanings. It is used
// for error messages of commands, in Python and in the documentation. It does not depend on the
// host.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace bearing {

struct DeckVariable {
  const char *name;
  const char *initial;    // default as text, or "" if the value is provided by the style or the
                          // data
  const char *unit;       // "" for a word, a count or a ratio
  const char *range;      // "LO HI", "LO HI whole", "LO HI or V", "one_of A B ...", or "" for any
  const char *of;         // commands and styles that accept it, kinds of data, or a single deck
  const char *meaning;
  // for a constant of an oil, the models that use it (`file` for a file of keywords), or "" for all
  // models
  const char *models = "";
  const char *without_default = "";    // kinds of data in `of` to which the default does not apply

  std::string label() const;    // name and unit, for messages
  bool taken_by(const std::string &command) const;
  // Returns true if the data of a kind must include the variable.
  bool needed_by(const std::string &kind) const;
  bool of_one_deck() const;    // `of` is the file name of that deck
  bool of_data() const;        // the variable is part of a bearing's or an oil's data file
  bool taken_by_models(const std::string &) const;
};

const std::vector<DeckVariable> &deck_variables();
// Returns the variables that belong to a command, a style, a kind of data or a deck.
std::vector<DeckVariable> variables_of(const std::string &of);
const DeckVariable *find_deck_variable(const std::string &name);

// Return the default of a variable. For a number, it must have one.
double usual_number(const std::string &name);
std::string usual_word(const std::string &name);

// Returns a message if a data file contains a name that is not a variable, but differs by only one
// or two letters from a variable that is missing in the file and whose default would therefore be
// used. Returns "" if there is no such name. Users may add any other names.
std::string mistyped(const std::set<std::string> &names);

// Returns the reason why a variable cannot have the given value, or "" if it can.
std::string wrong_value(const DeckVariable &, const std::string &value);

}    // namespace bearing
