// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_files.h"

#include "../deck/agree.h"
#include "../deck/arguments.h"
#include "../deck/column_list.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <set>

using namespace LAMMPS_NS;
namespace fs = std::filesystem;
using bearing::agree;
using bearing::Arguments;
using bearing::text;

void BearingInput::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_input", narg, arg, 0);
  const std::string folder = args.word("folder"), name = args.word("name");
  if (args.more()) args.unknown("none, the command ends here");
  const fs::path file = fs::path(folder) / name;
  std::string complaint;
  if (comm->me == 0) {
    std::error_code ec;
    if (!fs::is_regular_file(file, ec)) {
      std::set<std::string> names;
      for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
        names.insert(it->path().filename().string());
      std::string list;
      for (const std::string &n : names) list += (list.empty() ? "" : ", ") + n;
      complaint = "there is no '" + name + "' in folder " + folder + "; there is: " +
                  (list.empty()
                       ? "nothing (run from the folder that holds it, or set the variable 'inputs')"
                       : list);
    }
  }
  complaint = agree(complaint, world);
  if (!complaint.empty()) args.fail(complaint);
  input->one(("include " + file.string()).c_str());
}

void BearingOutput::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_output", narg, arg, 0);
  const std::string folder = args.word("folder");
  if (args.more()) args.unknown("none, the command ends here");
  std::string complaint;
  if (comm->me == 0) {
    std::error_code ec;
    fs::create_directories(folder, ec);
    if (ec) {
      complaint = "cannot make output folder '" + folder + "': " + ec.message();
    } else {
      const fs::path probe = fs::path(folder) / ".writable";
      std::ofstream out(probe);
      out << "x" << std::flush;
      if (!out) complaint = "output folder '" + folder + "' is not writable: " + strerror(errno);
      out.close();
      fs::remove(probe, ec);
    }
  }
  complaint = agree(complaint, world);
  if (!complaint.empty()) args.fail(complaint);
}

void BearingRange::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_range", narg, arg, 0);
  const std::string name = args.word("name");
  const std::string value = args.word("value of " + name);
  const double lo = args.number("lowest " + name), hi = args.number("highest " + name);
  const bool whole = args.take("whole");
  const std::string advice = args.take("advice") ? " (" + args.word("advice") + ")" : "";
  if (args.more()) args.unknown("whole, advice");
  Arguments given(lmp, "bearing_range", {value});
  const double v = given.number(name);
  if (!(v >= lo && v <= hi) || (whole && v != std::floor(v)))
    args.fail(name + " is " + text(v) + ", must be " + (whole ? "a whole number " : "") + "from " +
              text(lo) + " to " + text(hi) + advice);
}

// A string variable; one of that name and style gets the new value
static void replace(Variable *variable, std::string name, std::string value)
{
  std::string style = "string";
  char *words[] = {&name[0], &style[0], &value[0]};
  variable->set(3, words);
}

// A string variable, unless a variable of that name is there already
static void suggest(Variable *variable, std::string name, const std::string &value)
{
  if (variable->find(&name[0]) < 0) replace(variable, name, value);
}

void BearingHost::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_host", narg, arg, 0);
  const std::string kind = args.word("variable for the kind of host"),
                    name = args.word("variable for its name");
  if (args.more()) args.unknown("none, the command ends here");
  suggest(input->variable, kind, BRG_HOST_KIND);
  suggest(input->variable, name, BRG_HOST_NAME);
}

void BearingResume::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_resume", narg, arg, 0);
  const std::string name = args.word("name of a variable");
  const bool asked = args.choice("resume", {"no", "yes"}) == 1;
  const std::string file = args.word("restart file");
  if (args.more()) args.unknown("none, the command ends here");
  std::error_code ec;
  int there = comm->me == 0 && fs::is_regular_file(file, ec) ? 1 : 0;
  MPI_Bcast(&there, 1, MPI_INT, 0, world);
  if (asked && comm->me == 0) {
    const std::string say =
        there ? "Going on from " + file + "\n" : "No " + file + " to go on from: starting anew\n";
    if (screen) fputs(say.c_str(), screen);
    if (logfile) fputs(say.c_str(), logfile);
  }
  input->one(("variable " + name + " delete").c_str());
  input->one(("variable " + name + " index " + (asked && there ? "yes" : "no")).c_str());
}

void BearingColumns::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_columns", narg, arg, 0);
  const std::string id = args.word("ID of a compute");
  if (args.more()) args.unknown("none, the command ends here");
  const int k = modify->find_compute(id.c_str());
  if (k < 0) args.fail("there is no compute '" + id + "'");
  const auto *list = dynamic_cast<const bearing::ColumnList *>(modify->compute[k]);
  if (!list)
    args.fail("compute '" + id + "' is of style " + modify->compute[k]->style +
              ", must be bearing/contact, bearing/ball or bearing/ring");
  std::string names, values, formats;
  const std::vector<bearing::ColumnList::Item> items = list->columns();
  for (size_t n = 0; n < items.size(); ++n) {
    const char *gap = n ? " " : "";
    names += gap + items[n].name;
    values += gap + ("c_" + id) + (items.size() > 1 ? "[" + std::to_string(n + 1) + "]" : "");
    formats += gap + items[n].format;
  }
  replace(input->variable, id + "_columns", names);
  replace(input->variable, id + "_values", values);
  replace(input->variable, id + "_format", '"' + formats + '"');
}
