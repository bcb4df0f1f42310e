// SPDX-License-Identifier: GPL-2.0-or-later
// The variables of decks: name, default, unit, range and meaning, in one table for the errors of
// commands, for Python and for the pages. Independent of the host.
#ifndef BEARING_DECK_VARIABLE_TABLE_H
#define BEARING_DECK_VARIABLE_TABLE_H

#include <set>
#include <string>
#include <vector>

namespace bearing {

struct DeckVariable {
  const char *name;
  const char *initial;    // default as text; "": the style's default, or the data must provide it
  const char *unit;       // "": a word, a count or a ratio
  const char *range;      // "LO HI", "LO HI whole", "LO HI or V", "one_of A B ..."; "": any words
  const char *of;         // commands and styles that take it, a kind of data, or one deck
  const char *meaning;
  // for a constant of an oil: the models that take it, `file` for a file of keywords; "": all
  const char *models = "";

  std::string label() const;    // name and unit, for messages
  bool taken_by(const std::string &command) const;
  bool of_one_deck() const;    // `of` is the name of its file
  bool of_data() const;        // of a bearing or an oil, in data files
  bool taken_by_models(const std::string &) const;
};

const std::vector<DeckVariable> &deck_variables();
const DeckVariable *find_deck_variable(const std::string &name, const std::string &of = "");

// Message about a name in a data file that is not a variable but differs by one or two letters from
// a variable that the file lacks and whose default would be used; "" if there is none. Other names
// are the user's own.
std::string mistyped(const std::set<std::string> &names);

// Reason why a variable cannot have this value; "" if it can.
std::string wrong_value(const DeckVariable &, const std::string &value);

}    // namespace bearing

#endif
