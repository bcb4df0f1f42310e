// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_variables.h"

#include "../core/settings/arguments.h"
#include "../deck/agree.h"
#include "../deck/given_variables.h"
#include "deck_values.h"

#include <sstream>

using namespace LAMMPS_NS;
using bearing::Arguments;
using bearing::collect_folder;
using bearing::Names;
using bearing::words_after;

void BearingVariables::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_variables", narg, arg, 0);
  std::vector<std::string> folders;
  while (args.more()) folders.push_back(args.word("folder"));
  std::string complaint;
  if (comm->me == 0) {
    Names names;
    bearing::collect_deck(infile, names);
    for (const std::string &folder : folders) collect_folder(folder, names);
    for (std::string set : words_after("-var", "-v")) {
      // the word after -v of another program, such as python, is not a variable
      if (names.empty() || input->variable->find(&set[0]) < 0) continue;
      const char *value = input->variable->retrieve(&set[0]);
      const std::string wrong = names.count(set) ? bearing::wrong_with(value ? value : "")
                                                 : ": the deck has no such variable, nearest is '" +
                                                       bearing::nearest(set, names) + "'";
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
      if (!bearing::collect(table, names)) complaint = "cannot read table '" + table + "'";
    Names set = words_after("-var", "-v");
    set.merge(bearing::set_by_deck());
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
