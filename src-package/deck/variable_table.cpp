// SPDX-License-Identifier: GPL-2.0-or-later
#include "variable_table.h"

#include <iomanip>
#include <sstream>

using namespace LAMMPS_NS;

namespace bearing {

static void check_word(Arguments &args, const std::string &label, const std::string &value)
{
  std::string list;
  bool known = false;
  while (args.more()) {
    const std::string word = args.word("a value of " + label);
    known = known || word == value;
    list += (list.empty() ? "" : ", ") + word;
  }
  if (!known) args.fail(label + " is '" + value + "', must be one of " + list);
}

void check_range(Arguments &args, const std::string &label, const std::string &value)
{
  if (args.take("one_of")) return check_word(args, label, value);
  const double lo = args.number("lowest " + label), hi = args.number("highest " + label);
  const bool whole = args.take("whole"), or_more = args.take("or");
  const double also = or_more ? args.number("another value of " + label) : lo;
  const std::string advice = args.take("advice") ? " (" + args.word("advice") + ")" : "";
  if (args.more()) args.unknown("whole, or, advice");
  const double v = args.number_in(value, label);
  // the host's formulas do not accept the other number formats of C (hex, inf, nan)
  if (value.find_first_not_of("0123456789.eE+-") != std::string::npos || value[0] == '+')
    args.fail(label + " must be a number like 5000 or 5.0e3, not '" + value + "'");
  if (or_more && v == also) return;
  if (!(v >= lo && v <= hi) || (whole && v != std::floor(v)))
    args.fail(label + " is " + text(v) + ", must be " + (whole ? "a whole number " : "") + "from " +
              text(lo) + " to " + text(hi) + (or_more ? ", or " + text(also) : "") + advice);
}

VariableTable::VariableTable(LAMMPS *lmp, const Arguments &args, const std::string &file) :
    Pointers(lmp)
{
  const std::string all = args.content(file).value_or("");
  if (all.empty()) args.fail("there is no table of variables in '" + file + "'");
  std::istringstream lines(all);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      rows_.push_back(read(line, file + ", line " + std::to_string(number)));
  }
}

VariableTable::Row VariableTable::read(const std::string &line, const std::string &place) const
{
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; in >> std::quoted(word);) words.push_back(word);
  Arguments args(lmp, place, words);
  if (!args.take("variable")) args.unknown("variable");
  Row row;
  row.name = row.label = args.word("name of a variable");
  if (args.choice("kind of variable", {"needed", "index"}) == 1) row.value = args.word("default");
  if (args.take("unit")) row.label += " (" + args.word("unit") + ")";
  const bool number = args.take("range");
  if (args.more() && !number && args.next() != "one_of") args.unknown("unit, range, one_of");
  while (args.more()) row.range.push_back(args.word("range"));
  return row;
}

bool VariableTable::there(const std::string &name) const
{
  return input->variable->find(const_cast<char *>(name.c_str())) >= 0;
}

std::vector<std::string> VariableTable::missing() const
{
  std::vector<std::string> names;
  for (const Row &row : rows_)
    if (row.value.empty() && !there(row.name)) names.push_back(row.name);
  return names;
}

void VariableTable::check() const
{
  for (const Row &row : rows_) {
    if (!there(row.name)) input->one(("variable " + row.name + " index " + row.value).c_str());
    if (row.range.empty()) continue;
    const char *value = input->variable->retrieve(const_cast<char *>(row.name.c_str()));
    Arguments range(lmp, "bearing_range", row.range);
    if (!value) range.fail("variable " + row.name + " has no value that is one number or word");
    check_range(range, row.label, value);
  }
}

}    // namespace bearing
