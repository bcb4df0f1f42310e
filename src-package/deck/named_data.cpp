// SPDX-License-Identifier: GPL-2.0-or-later
#include "named_data.h"

#include "../core/settings/data_table.h"
#include "bearing_compat.h"
#include "find_data.h"
#include "given_variables.h"

#include <algorithm>
#include <sstream>

namespace bearing {

// Returns the names that are known on the first rank, which reads the command line and the decks.
static Names of_first_rank(LAMMPS_NS::LAMMPS *lmp, const Names &names)
{
  const auto all = words_of(of_first_rank(lmp, joined({names.begin(), names.end()}, " ")));
  return {all.begin(), all.end()};
}

NamedData read_data(LAMMPS_NS::LAMMPS *lmp, const Arguments &args, const std::string &inputs,
                    const std::string &sort, const std::string &name)
{
  Data text;
  if (is_first_rank(lmp)) text = find_data(inputs + "/" + sort, name);
  const std::string complaint = of_first_rank(lmp, text.complaint);
  if (!complaint.empty()) args.fail(complaint);
  NamedData data;
  data.label = of_first_rank(lmp, text.label);
  const std::string lines = of_first_rank(lmp, text.lines);
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string command, key, style, value;
    if (!(words >> command)) continue;
    if (command != "variable" || !(words >> key >> style >> value) || style != "index")
      args.fail(data.label + ": a line of data is 'variable NAME index VALUE', not '" + line + "'");
    data.values.emplace(key, value);
  }
  Names known;
  for (const auto &value : data.values) known.insert(value.first);
  if (const std::string wrong = mistyped(known); !wrong.empty())
    args.fail(data.label + ": " + wrong);
  data.of_file = data.values;
  for (const DeckVariable &v : deck_variables())
    if (v.of_data()) known.insert(v.name);
  const bool first = is_first_rank(lmp);
  const Names deck = of_first_rank(lmp, first ? set_by_deck() : Names());
  Names all = of_first_rank(lmp, first ? words_after("-var", "-v") : Names());
  all.insert(deck.begin(), deck.end());
  for (const std::string &one : known) {
    if (deck.count(one)) data.of_deck.push_back(one);
    if (!all.count(one)) continue;
    if (const auto value = host_variable(lmp, one)) data.values[one] = *value;
  }
  // data that are not needed may be used nevertheless, for example the bore by starvation
  for (const DeckVariable &v : deck_variables())
    if (v.of_data() && data.values.count(v.name)) check_datum(args, data, v);
  return data;
}

std::vector<std::string> given_of(const NamedData &data, const std::vector<std::string> &kinds)
{
  std::vector<std::string> list;
  for (const auto &value : data.values) {
    const auto of_file = data.of_file.find(value.first);
    const DeckVariable *const of = find_deck_variable(value.first);
    const bool asked = of && std::any_of(kinds.begin(), kinds.end(),
                                         [of](const auto &kind) { return of->taken_by(kind); });
    if (asked && (of_file == data.of_file.end() || of_file->second != value.second))
      list.push_back(value.first + "=" + value.second);
  }
  return list;
}

std::string note_of_deck(const NamedData &data)
{
  std::string list;
  for (const std::string &name : data.of_deck) {
    const auto of_file = data.of_file.find(name);
    if (of_file == data.of_file.end() || of_file->second == data.values.at(name)) continue;
    const DeckVariable *const of = find_deck_variable(name);
    if (of && !of->of_data()) continue;    // variables such as the temperature belong to the pair
                                           // style
    list += (list.empty() ? "" : ", ") + name + " " + data.values.at(name) + " instead of " +
            of_file->second;
  }
  return list.empty() ? ""
                      : "Data of " + data.label + " by variables of the deck: " + list +
                            ". Rename a variable that has another meaning";
}

void check_datum(const Arguments &args, const NamedData &data, const DeckVariable &v)
{
  const std::string &value = data.values.at(v.name), wrong = wrong_value(v, value);
  const auto of_file = data.of_file.find(v.name);
  const bool from_file = of_file != data.of_file.end() && of_file->second == value;
  if (!wrong.empty()) args.fail((from_file ? data.label + ": " : "") + wrong);
}

std::vector<std::string> check_data(const Arguments &args, NamedData &data, const std::string &of)
{
  std::vector<std::string> missing, assumed;
  for (const DeckVariable &v : variables_of(of)) {
    if (data.values.count(v.name)) continue;
    (v.needed_by(of) ? missing : assumed).push_back(v.name);
    data.values[v.name] = v.initial;
  }
  if (!missing.empty()) args.fail(data.label + " has no variable " + joined(missing));
  for (const DeckVariable &v : variables_of(of)) check_datum(args, data, v);
  return assumed;
}

}    // namespace bearing
