// SPDX-License-Identifier: GPL-2.0-or-later
#include "named_data.h"

#include "../core/settings/data_table.h"
#include "../core/settings/deck_variable_table.h"
#include "agree.h"
#include "find_data.h"
#include "given_variables.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace bearing {

namespace {

// On one rank: the text of the data, and a message if there is none
struct Text {
  std::string complaint, label, lines;
};

Text text_of(const std::string &folder, const std::string &name)
{
  std::error_code ec;
  const bool path = name.find('/') != std::string::npos && fs::is_regular_file(name, ec);
  const fs::path file = path ? fs::path(name) : fs::path(folder) / name;
  Text text;
  const Data data = path ? find_data(file.parent_path().string(), file.filename().string())
                         : find_data(folder, name);
  text.complaint = data.complaint;
  text.label = data.label;
  if (data.commands != "include " + file.string()) {
    text.lines = data.commands;
  } else {
    std::ostringstream all;
    all << std::ifstream(file).rdbuf();
    text.lines = all.str();
  }
  return text;
}

// Names set by the user with -var or in the deck that are names of data
Names given_names(const Names &of_file)
{
  Names set = words_after("-var", "-v"), found;
  set.merge(set_by_deck());
  for (const std::string &name : set)
    if (of_file.count(name)) found.insert(name);
  for (const DeckVariable &v : deck_variables())
    if (v.of_data() && set.count(v.name)) found.insert(v.name);
  return found;
}

}    // namespace

NamedData read_data(LAMMPS_NS::LAMMPS *lmp, const Arguments &args, const std::string &inputs,
                    const std::string &sort, const std::string &name)
{
  Text text;
  if (is_first_rank(lmp)) text = text_of(inputs + "/" + sort, name);
  const std::string complaint = agree(text.complaint, lmp->world);
  if (!complaint.empty()) args.fail(complaint);
  NamedData data{agree(text.label, lmp->world), {}, {}};
  const std::string lines = agree(text.lines, lmp->world);
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string command, key, style, value;
    if (!(words >> command >> key >> style) || command != "variable") continue;
    if (style != "index" || !(words >> value))
      args.fail(data.label + ": a line of data is 'variable NAME index VALUE', not '" + line + "'");
    data.values.emplace(key, value);
  }
  data.of_file = data.values;
  Names of_file;
  for (const auto &value : data.values) of_file.insert(value.first);
  std::string given;
  if (is_first_rank(lmp))
    for (const std::string &one : given_names(of_file)) given += one + " ";
  std::istringstream names(agree(given, lmp->world));
  for (std::string one; names >> one;)
    if (const auto value = host_variable(lmp, one)) data.values[one] = *value;
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
