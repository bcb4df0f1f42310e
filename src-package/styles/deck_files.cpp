// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_files.h"

#include "../core/settings/arguments.h"
#include "../deck/agree.h"
#include "../deck/find_data.h"
#include "../deck/variable_table.h"
#include "result_folder.h"
#include "simulated_time.h"
#include "spheres.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

using namespace LAMMPS_NS;
namespace fs = std::filesystem;
using bearing::agree;
using bearing::Arguments;
using bearing::check_range;
using bearing::joined;
using bearing::VariableTable;

void BearingInput::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_input", narg, arg, 0);
  const std::string folder = args.word("folder"), name = args.word("name");
  std::vector<std::string> keys;
  std::unique_ptr<VariableTable> table;
  const bool included = args.take("set");
  if (included && args.take("table")) {
    table = std::make_unique<VariableTable>(lmp, args, args.word("table of variables"));
    keys = table->missing();
  } else if (included || args.take("needs")) {
    while (args.more()) keys.push_back(args.word("name of a variable"));
  }
  if (args.more()) args.unknown("needs, set, table");
  bearing::Data data;
  if (comm->me == 0) {
    data = bearing::find_data(folder, name);
    std::vector<std::string> missing;
    for (std::string &key : keys)
      if (!data.variables.count(key) && input->variable->find(&key[0]) < 0) missing.push_back(key);
    if (data.complaint.empty() && !missing.empty())
      data.complaint = data.label + " has no variable " + joined(missing);
  }
  const std::string complaint = agree(data.complaint, world);
  if (!complaint.empty()) args.fail(complaint);
  std::istringstream commands(included ? "" : agree(data.commands, world));
  for (std::string line; std::getline(commands, line);) input->one(line.c_str());
  if (table) table->check();
}

void BearingOutput::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_output", narg, arg, 0);
  const std::string folder = args.word("folder");
  std::vector<std::string> old;
  if (args.take("remove"))
    while (args.more()) old.push_back(args.word("name of a file"));
  if (args.more())
    args.fail("a folder's name is one word without blanks, not '" + folder + " " +
              args.word("folder") + "'");
  bearing::claim_result_folder(lmp, args, folder);
  if (comm->me == 0)
    for (const std::string &name : old) {
      std::error_code ec;
      fs::remove(fs::path(folder) / name, ec);
    }
}

void BearingRange::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_range", narg, arg, 0);
  const std::string name = args.word("name");
  if (name != "table" || args.left() > 1)
    return check_range(args, name, args.word("value of " + name));
  const std::string file = args.word("table of variables");
  const VariableTable table(lmp, args, file);
  const std::string missing = joined(table.missing());
  if (!missing.empty()) args.fail("the deck has no variable " + missing + ", see '" + file + "'");
  table.check();
}

// Sets a string variable; an existing one of that name and style gets the new value
static void replace(Variable *variable, std::string name, std::string value)
{
  std::string style = "string";
  char *words[] = {&name[0], &style[0], &value[0]};
  variable->set(3, words);
}

// Sets a string variable unless a variable of that name exists
static void suggest(Variable *variable, std::string name, const std::string &value)
{
  if (variable->find(&name[0]) < 0) replace(variable, name, value);
}

void BearingHost::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_host", narg, arg, 0);
  const std::string kind = args.word("variable for the kind of host"),
                    name = args.word("variable for its name");
  const bool bearings = args.take("bearings"), spheres = bearings || args.take("spheres");
  const std::string format = spheres ? args.word("variable for the format of a line") : "";
  if (args.more()) args.unknown("spheres, bearings");
  suggest(input->variable, kind, BRG_HOST_KIND);
  suggest(input->variable, name, BRG_HOST_NAME);
  if (!spheres) return;
  suggest(input->variable, format, bearing::line_format());
  if (bearings) input->one("units si");
  input->one((std::string("atom_style ") + bearing::sphere_style()).c_str());
  input->one(bearing::ghost_velocities());
  if (!bearings) return;
  // settings the styles need, and one subdomain along the axis
  for (const char *command : {"atom_modify map array sort 0 0.0", "newton off", "processors * * 1"})
    input->one(command);
}

void BearingWords::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_words", narg, arg, 0);
  const std::string name = args.word("name of a variable");
  std::string words = args.word("words of " + name);
  while (args.more()) words += " " + args.word("words of " + name);
  replace(input->variable, name, words);
}

void BearingParts::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_parts", narg, arg, 0);
  const std::string prefix = args.word("start of the variables' names"),
                    without = args.word("parts to leave out");
  std::set<std::string> out;
  std::istringstream list(without == "none" ? "" : without);
  for (std::string name; std::getline(list, name, '+');) out.insert(name);
  std::string there;
  while (args.more()) {
    const std::string name = args.word("name of a part");
    replace(input->variable, prefix + name, out.erase(name) ? "0" : "1");
    there += (there.empty() ? "" : " ") + name;
  }
  replace(input->variable, prefix + "parts", there.empty() ? "none" : there);
  if (!out.empty())
    args.fail("there is no part '" + *out.begin() + "' to leave out in '" + without +
              "'; there is: " + (there.empty() ? "none" : there) +
              ". Names are joined by +, or the word is none");
}

void BearingStep::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_step", narg, arg, 0);
  const int step = args.integer("number of the step", 0, 2000000000);
  if (args.more()) args.unknown("none, the command ends here");
  const double time = bearing::SimulatedTime::now(*update);
  input->one(("reset_timestep " + std::to_string(step)).c_str());
  bearing::SimulatedTime::set(*update, time);
}
