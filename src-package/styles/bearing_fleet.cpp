// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_fleet.h"

#include "../core/settings/driven_value.h"
#include "create_bearing.h"
#include "deck_values.h"

#include <fstream>
#include <sstream>

using namespace LAMMPS_NS;
using bearing::Arguments;
using bearing::DeckValues;

void BearingFleet::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_fleet", narg, arg, 0);
  const Fleet fleet = parse(args);
  std::vector<int> numbers;
  for (int k = fleet.first; k <= fleet.last; k += fleet.step)
    if (fleet.only == 0 || fleet.only == k) numbers.push_back(k);
  for (int k : numbers) create(args, fleet, k, k == numbers.back());
}

BearingFleet::Fleet BearingFleet::parse(Arguments &args)
{
  constexpr int most = 10000000;
  Fleet f;
  read(args, args.word("file of the fleet"), f);
  while (args.more()) {
    if (args.take("numbers")) {
      f.first = args.integer("first number", 1, most);
      f.last = args.integer("last number", 0, most);
      f.step = args.integer("step of the numbers", 1, most);
    } else if (args.take("only")) {
      f.only = args.integer("number of the only bearing", 0, most);
    } else if (args.take("grid")) {
      f.columns = args.integer("columns of the grid", 1, most);
      auto spacing = bearing::DrivenValue::read(args, "spacing of the grid (m)");
      spacing.check(lmp, "bearing_fleet");
      f.spacing = spacing.now(lmp);
    } else if (args.take("tables")) {
      f.folder = args.word("folder of the tables");
      f.note = args.word("note");
    } else if (args.take("create")) {
      while (args.more()) f.words.push_back(args.word("word of create_bearing"));
    } else {
      args.unknown("numbers, only, grid, tables, create");
    }
  }
  if (f.first == 0) args.fail("'numbers FIRST LAST STEP' is missing");
  if (f.columns == 0) args.fail("'grid COLUMNS SPACING' is missing");
  if (f.folder.empty()) args.fail("'tables FOLDER NOTE' is missing");
  if (f.words.empty()) args.fail("'create WORD ...' is missing");
  return f;
}

// The host runs an include only after this command has ended, so the file is read here.
void BearingFleet::read(Arguments &args, const std::string &file, Fleet &f)
{
  const std::optional<std::string> all = args.content(file);
  if (!all) args.fail("cannot read '" + file + "'");
  std::istringstream lines(*all);
  std::string command;
  for (std::string line; std::getline(lines, line);) {
    command += line.substr(0, line.find('#'));
    const size_t end = command.find_last_not_of(" \t\r");
    if (end == std::string::npos) {
      command.clear();
    } else if (command[end] == '&') {
      command.erase(end);
    } else {
      f.commands.push_back(command);
      command.clear();
    }
  }
}

void BearingFleet::create(const Arguments &args, const Fleet &f, int number, bool last)
{
  DeckValues deck(lmp, args);
  deck.set("b_k", number);
  for (const std::string &command : f.commands) input->one(command.c_str());
  const double load = deck.formula("this_load"), speed = 2 * M_PI * deck.formula("this_rpm") / 60;
  const int row = (number - 1) / f.columns;
  const std::string x = DeckValues::written((number - 1 - row * f.columns + 0.5) * f.spacing),
                    y = DeckValues::written((row + 0.5) * f.spacing),
                    turns = DeckValues::written(speed);
  std::vector<std::string> words = f.words;
  for (const std::string &word :
       {std::string("centre"), x, y, std::string("0"), std::string("phase"),
        deck.word("this_phase"), std::string("speed"), turns, std::string("0")})
    words.push_back(word);
  if (last) words.insert(words.end(), {"groups", "yes"});
  std::vector<char *> list;
  for (std::string &word : words) list.push_back(&word[0]);
  CreateBearing(lmp).command(static_cast<int>(list.size()), list.data());
  const std::string given = deck.word("this_load") + " " + deck.word("this_rpm");
  if (comm->me != 0) return;
  const std::string ring = DeckValues::written(static_cast<double>(atom->natoms) - 1.0);
  const auto add = [&](const char *table, const std::string &line) {
    std::ofstream to(f.folder + "/" + table, std::ios::app);
    if (!(to << line << std::endl))
      BRG_ONE("bearing_fleet: cannot write " + f.folder + "/" + table);
  };
  add("fleet.txt",
      std::to_string(number) + " " + ring + " " + x + " " + y + " " + given + " " + f.note);
  add("load.atoms", ring + " " + DeckValues::written(-load));
  add("speed.atoms", ring + " " + turns);
}
