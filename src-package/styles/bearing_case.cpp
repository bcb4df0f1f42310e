// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_case.h"

#include "../core/settings/arguments.h"

using namespace LAMMPS_NS;
using bearing::Arguments;

static bool is_command(const std::string &word) { return word.find(' ') != std::string::npos; }

void BearingCase::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_case", narg, arg, 0);
  const std::string name = args.word("name"), value = args.word("value of " + name);
  std::vector<std::string> commands;
  std::string list;
  bool found = false;
  while (args.more()) {
    const std::string word = args.word("a value of " + name);
    if (is_command(word)) args.fail("a value of " + name + " comes before '" + word + "'");
    list += (list.empty() ? "" : ", ") + word;
    const bool taken = !found && word == value;
    found = found || taken;
    while (args.more() && is_command(args.next())) {
      const std::string command = args.word("command");
      if (taken) commands.push_back(command);
    }
  }
  if (!found) args.fail(name + " is '" + value + "', must be one of " + list);
  for (const std::string &command : commands) input->one(command.c_str());
}
