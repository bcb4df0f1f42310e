// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_columns.h"

#include "../core/settings/arguments.h"
#include "../core/settings/written.h"
#include "../deck/column_list.h"
#include "bearing_compat.h"

using namespace LAMMPS_NS;
using bearing::Arguments;

// Finds the columns of a compute, as c_ID[k], or of a fix, as variables that `fix print` replaces
// with numbers.
static const bearing::ColumnList *find_list(LAMMPS *lmp, Arguments &args, const std::string &id,
                                            bool &compute)
{
  const int c = lmp->modify->find_compute(id.c_str()), f = lmp->modify->find_fix(id.c_str());
  compute = c >= 0;
  if (c < 0 && f < 0) args.fail("there is no compute or fix '" + id + "'");
  const auto *list = compute ? dynamic_cast<const bearing::ColumnList *>(lmp->modify->compute[c])
                             : dynamic_cast<const bearing::ColumnList *>(lmp->modify->fix[f]);
  if (!list)
    args.fail((compute ? "compute '" : "fix '") + id + "' is of style " +
              (compute ? lmp->modify->compute[c]->style : lmp->modify->fix[f]->style) +
              ", must be a compute bearing/contact, bearing/ball or bearing/ring or a fix "
              "bearing/ring or bearing/shaft");
  return list;
}

namespace {
struct Columns {
  bool compute;
  std::string names, values, format;
};
}    // namespace

static Columns columns_of(LAMMPS *lmp, Arguments &args, const std::string &id)
{
  Columns all;
  const bearing::ColumnList *list = find_list(lmp, args, id, all.compute);
  const std::vector<bearing::ColumnList::Item> items = list->columns();
  all.names = all.compute ? "" : "# step time";
  all.values = all.compute ? "" : "$(step) $(step*dt)";
  for (size_t n = 0; n < items.size(); ++n) {
    const char *gap = n ? " " : "";
    const std::string at = items.size() > 1 ? "[" + std::to_string(n + 1) + "]" : "";
    all.names += (all.compute ? gap : " ") + items[n].name;
    all.values += all.compute ? gap + ("c_" + id) + at : " $(f_" + id + at + ")";
    all.format += gap + items[n].format;
  }
  return all;
}

static std::string quoted(const std::string &words) { return '"' + words + '"'; }

void BearingDump::command(int narg, char **arg)
{
  Arguments args(lmp, "bearing_dump", narg, arg, 0);
  const std::string id = args.word("ID"), group = args.word("group"),
                    every = std::to_string(args.integer("steps between samples", 1, 1000000000)),
                    file = args.word("file"), source = args.word("ID of a compute or fix");
  bool append = false;
  std::string names;
  while (args.more())
    if (!args.yes("append", append) && !args.word("columns", names, "name of a variable"))
      args.unknown();
  const Columns of = columns_of(lmp, args, source);
  if (!names.empty())
    bearing::pass_words({names, "string", of.names},
                        [this](int n, char **words) { input->variable->set(n, words); });
  if (of.compute) {
    input->one(
        ("dump " + id + " " + group + " local " + every + " " + file + " " + of.values).c_str());
    input->one(("dump_modify " + id + " append " + (append ? "yes " : "no ") + BRG_LINE_FORMAT " " +
                quoted(of.format))
                   .c_str());
    return;
  }
  // A file that is continued already contains its title. During the set-up of a run, LAMMPS writes
  // the title `none` and a row, both of which are removed by fix bearing/checkpoint.
  input->one(("fix " + id + " " + group + " print " + every + " " + quoted(of.values) +
              (append ? " append " : " file ") + file + " screen no title " +
              (append ? "none" : quoted(of.names)))
                 .c_str());
}
