// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_variables.h"

#include "../core/settings/arguments.h"
#include "../core/settings/data_table.h"
#include "../deck/agree.h"
#include "deck_values.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace LAMMPS_NS;
namespace fs = std::filesystem;
using bearing::Arguments;

namespace {

typedef std::set<std::string> Names;

// Command line of the program; the host keeps no copy of it.
std::vector<std::string> command_line()
{
  std::ifstream file("/proc/self/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

// Words that follow either of two options
Names words_after(const char *option, const char *other)
{
  Names found;
  const std::vector<std::string> words = command_line();
  for (size_t k = 0; k + 1 < words.size(); ++k)
    if (words[k] == option || words[k] == other) found.insert(words[k + 1]);
  return found;
}

// Collects the variables that -var may set in a deck: those of styles that keep such a value, those
// of tables (deck/variable_table.h), and the two of bearing_host. False: the file cannot be read.
bool collect(const fs::path &path, Names &names)
{
  static const Names styles = {"index", "string", "loop", "uloop", "universe", "world", "needed"};
  std::ifstream file(path);
  if (!file) return false;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string command, first, second;
    words >> command >> first >> second;
    if (command == "variable" && styles.count(second)) names.insert(first);
    if (command == "bearing_host") names.insert({first, second});
  }
  return true;
}

// Variables that a line `variable NAME index VALUE` of the deck sets
Names set_by_deck()
{
  Names found;
  for (const std::string &deck : words_after("-in", "-i")) {
    std::ifstream file(deck);
    for (std::string line; std::getline(file, line);) {
      std::istringstream words(line);
      std::string command, name, style;
      if (words >> command >> name >> style && command == "variable" && style == "index")
        found.insert(name);
    }
  }
  return found;
}

// Collects them from all files and tables in a folder; returns the error if it cannot be read.
std::error_code collect_folder(const std::string &folder, Names &names)
{
  std::error_code ec;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() != ".csv") collect(it->path(), names);
  for (const bearing::DataTable &table : bearing::tables_of(folder)) names.merge(table.variables());
  return ec;
}

std::string nearest(const std::string &name, const Names &names)
{
  return *std::min_element(names.begin(), names.end(),
                           [&](const std::string &a, const std::string &b) {
                             return bearing::distance(name, a) < bearing::distance(name, b);
                           });
}

bool is_number(const std::string &word)
{
  char *end = nullptr;
  std::strtod(word.c_str(), &end);
  return end != word.c_str() && *end == '\0';
}

// Complaint about a value of -var that is empty or a number with a unit; empty if it is neither
std::string wrong_with(const std::string &value)
{
  std::istringstream in(value);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  if (words.empty()) return " is empty";
  if (is_number(words[0]) && !std::all_of(words.begin(), words.end(), is_number))
    return " is '" + value + "': give a number alone, in the unit of the deck";
  return "";
}

}    // namespace

void BearingVariables::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_variables", narg, arg, 0);
  std::vector<std::string> folders;
  while (args.more()) folders.push_back(args.word("folder"));
  std::string complaint;
  if (comm->me == 0) {
    Names names;
    if (infile) collect("/proc/self/fd/" + std::to_string(fileno(infile)), names);
    // decks that include this one
    for (const std::string &deck : words_after("-in", "-i")) collect(deck, names);
    for (const std::string &folder : folders) collect_folder(folder, names);
    for (std::string set : words_after("-var", "-v")) {
      // the word after -v of another program, such as python, is not a variable
      if (names.empty() || input->variable->find(&set[0]) < 0) continue;
      const char *value = input->variable->retrieve(&set[0]);
      const std::string wrong = names.count(set) ? wrong_with(value ? value : "")
                                                 : ": the deck has no such variable, nearest is '" +
                                                       nearest(set, names) + "'";
      if (!wrong.empty()) complaint += (complaint.empty() ? "-var " : "; -var ") + set + wrong;
    }
  }
  complaint = bearing::agree(complaint, world);
  if (!complaint.empty()) args.fail(complaint);
}

void BearingGiven::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_given", narg, arg, 0);
  std::string name = args.word("variable");
  Names tables;
  while (args.more()) tables.insert(args.word("table of variables"));
  std::string all, complaint;
  if (comm->me == 0) {
    Names names;
    for (const std::string &table : tables)
      if (!collect(table, names)) complaint = "cannot read table '" + table + "'";
    Names set = words_after("-var", "-v");
    set.merge(set_by_deck());
    for (std::string given : set) {
      const char *value = names.count(given) ? input->variable->retrieve(&given[0]) : nullptr;
      if (value) all += (all.empty() ? "" : ",") + given + "=" + value;
    }
  }
  complaint = bearing::agree(complaint, world);
  if (!complaint.empty()) args.fail(complaint);
  all = bearing::agree(all, world);
  bearing::DeckValues(lmp, args).set(name, all.empty() ? "none" : all);
}

void BearingForget::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_forget", narg, arg, 0);
  Names names;
  std::string complaint;
  do {
    const std::string folder = args.word("folder");
    if (comm->me != 0) continue;
    if (const std::error_code ec = collect_folder(folder, names))
      complaint = "cannot read folder '" + folder + "': " + ec.message();
  } while (args.more());
  complaint = bearing::agree(complaint, world);
  if (!complaint.empty()) args.fail(complaint);
  std::string joined;
  for (const std::string &name : names) joined += name + " ";
  std::istringstream all(bearing::agree(joined, world));
  for (std::string name; all >> name;)
    if (input->variable->find(&name[0]) >= 0) input->one(("variable " + name + " delete").c_str());
}
