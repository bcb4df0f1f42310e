// SPDX-License-Identifier: GPL-2.0-or-later
#include "named_data.h"

#include "../core/settings/data_table.h"
#include "../core/settings/deck_variable_table.h"
#include "bearing_compat.h"
#include "find_data.h"
#include "given_variables.h"

#include <algorithm>
#include <sstream>

namespace bearing {

namespace {

// Returns the names of the data that the user has set with -var or in the deck.
Names given_names(const Names &set, const DataValues::Map &of_file)
{
  Names found;
  for (const std::string &name : set)
    if (of_file.count(name)) found.insert(name);
  for (const DeckVariable &v : deck_variables())
    if (set.count(v.name) && v.of_data()) found.insert(v.name);
  return found;
}

}    // namespace

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
  std::set<std::string> of_lines;
  for (const auto &value : data.values) of_lines.insert(value.first);
  if (const std::string wrong = mistyped(of_lines); !wrong.empty())
    args.fail(data.label + ": " + wrong);
  data.of_file = data.values;
  std::string given, of_deck;
  if (is_first_rank(lmp)) {
    const Names deck = set_by_deck();
    Names all = words_after("-var", "-v");
    all.insert(deck.begin(), deck.end());
    for (const std::string &one : given_names(all, data.of_file)) given += one + " ";
    for (const std::string &one : given_names(deck, data.of_file)) of_deck += one + " ";
  }
  std::istringstream names(of_first_rank(lmp, given)), own(of_first_rank(lmp, of_deck));
  for (std::string one; names >> one;)
    if (const auto value = host_variable(lmp, one)) data.values[one] = *value;
  for (std::string one; own >> one;) data.of_deck.push_back(one);
  return data;
}

std::vector<std::string> given_of(const NamedData &data, const std::vector<std::string> &kinds)
{
  std::vector<std::string> list;
  for (const auto &value : data.values) {
    const auto of_file = data.of_file.find(value.first);
    const bool asked = std::any_of(kinds.begin(), kinds.end(), [&](const std::string &kind) {
      return find_deck_variable(value.first, kind) != nullptr;
    });
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

std::vector<std::string> check_data(const Arguments &args, NamedData &data, const std::string &of)
{
  std::vector<std::string> missing, assumed;
  for (const DeckVariable &v : deck_variables()) {
    if (!v.taken_by(of) || data.values.count(v.name)) continue;
    if (*v.initial) data.values[v.name] = v.initial;
    (*v.initial ? assumed : missing).push_back(v.name);
  }
  if (!missing.empty()) args.fail(data.label + " has no variable " + joined(missing));
  for (const DeckVariable &v : deck_variables()) {
    if (!v.taken_by(of)) continue;
    const std::string wrong = wrong_value(v, data.values[v.name]);
    if (!wrong.empty()) args.fail(wrong);
  }
  return assumed;
}

}    // namespace bearing
