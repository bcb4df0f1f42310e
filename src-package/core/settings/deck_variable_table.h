// SPDX-License-Identifier: GPL-2.0-or-later
// The variables of decks with name, default, unit, range and meaning, in one table that is used for
// error messages of commands, in Python and in the documentation. Independent of the host.
#ifndef BEARING_DECK_VARIABLE_TABLE_H
#define BEARING_DECK_VARIABLE_TABLE_H

#include <set>
#include <string>
#include <vector>

namespace bearing {

struct DeckVariable {
  const char *name;
  const char *initial;    // default as text, or "" if the style or the data provide the value
  const char *unit;       // "" for a word, a count or a ratio
  const char *range;      // "LO HI", "LO HI whole", "LO HI or V", "one_of A B ...", or "" for any
  const char *of;         // commands and styles that take it, a kind of data, or one deck
  const char *meaning;
  // for a constant of an oil, the models that take it (`file` for a file of keywords), or "" for
  // all
  const char *models = "";

  std::string label() const;    // name and unit, for messages
  bool taken_by(const std::string &command) const;
  bool of_one_deck() const;    // `of` is the file name of that deck
  bool of_data() const;        // datum of a bearing or an oil in a data file
  bool taken_by_models(const std::string &) const;
};

const std::vector<DeckVariable> &deck_variables();
const DeckVariable *find_deck_variable(const std::string &name, const std::string &of = "");

// Returns a message about a name in a data file that is not a variable but differs by one or two
// letters from a variable that the file does not contain and whose default would be used, or "" if
// there is no such name. Users may add other names of their own.
std::string mistyped(const std::set<std::string> &names);

// Returns the reason why a variable cannot have this value, or "" if it can.
std::string wrong_value(const DeckVariable &, const std::string &value);

}    // namespace bearing

#endif
