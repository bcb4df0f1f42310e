// SPDX-License-Identifier: GPL-2.0-or-later
#include "arguments.h"

#include "data_table.h"
#include "deck_variable_table.h"
#include "deck_words.h"
#include "written.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>

using LAMMPS_NS::LAMMPS;

namespace bearing {

std::string text(double value)
{
  char buf[32];
  snprintf(buf, sizeof buf, "%.6g", value);
  return buf;
}

Arguments::Arguments(LAMMPS *lmp, const std::string &command, int narg, char **arg, int first) :
    lmp_(lmp), command_(command), words_(arg + (first < narg ? first : narg), arg + narg)
{
  take_variables();
  note_words(lmp, command, words_);
}

// Returns the style of "fix ID STYLE", or the command itself, under the name that the table of
// variables uses.
static std::string taker(const std::string &command)
{
  return command.compare(0, 4, "fix ") == 0 ? command.substr(command.rfind(' ') + 1) : command;
}

void Arguments::take_variables()
{
  const auto at = std::find(words_.begin(), words_.end(), "vars");
  if (at == words_.end()) return;
  const std::vector<std::string> names(at + 1, words_.end());
  words_.erase(at, words_.end());
  if (names.empty()) fail("'vars' needs the name of a variable");
  for (const std::string &name : names) {
    const DeckVariable *const entry = find_deck_variable(name);
    if (!entry) {
      std::vector<std::string> known;
      for (const DeckVariable &v : variables_of(taker(command_))) known.push_back(v.name);
      fail("vars '" + name + "', must be one of: " + (known.empty() ? "none" : joined(known)));
    }
    const std::optional<std::string> value = host_variable(lmp_, name);
    if (!value) continue;
    // a line whose style is given by a variable contains the words of all styles that it may select
    if (!entry->taken_by(taker(command_)))
      fail("variable " + name + " belongs to " + entry->of + ": leave it out here");
    words_.push_back(name);
    std::istringstream in(*value);
    for (std::string word; in >> std::quoted(word);) words_.push_back(word);
  }
}

std::string Arguments::value_of(const char *variable, const char *keyword)
{
  DeckVariable entry = *find_deck_variable(variable);
  if (keyword) entry.name = keyword;
  const std::string value = word(entry.name), wrong = wrong_value(entry, value);
  if (!wrong.empty()) fail(wrong);
  return value;
}

double Arguments::number_of(const char *variable, const char *keyword)
{
  return std::atof(value_of(variable, keyword).c_str());
}

bool Arguments::variable_of(const std::string &of, std::map<std::string, std::string> &to)
{
  for (const DeckVariable &v : variables_of(of))
    if (take(v.name)) return set(to[v.name], value_of(v.name));
  return false;
}

Arguments::Arguments(LAMMPS *lmp, const std::string &command,
                     const std::vector<std::string> &words) :
    lmp_(lmp), command_(command), words_(words)
{
}

void Arguments::fail(const std::string &why) const { stop_run(lmp_, command_ + ": " + why); }

std::optional<std::string> Arguments::content(const std::string &file) const
{
  std::string found;    // "+" followed by the text of a readable file
  if (is_first_rank(lmp_)) {
    std::ifstream in(file, std::ios::binary);
    // a folder can also be opened, but no data can be read from it
    const bool empty = in && in.peek() == std::ifstream::traits_type::eof() && !in.bad();
    std::ostringstream copy;
    if (empty || (in && copy << in.rdbuf())) found = "+" + copy.str();
  }
  found = of_first_rank(lmp_, found);
  if (found.empty()) return {};
  note_file(lmp_, command_, found);
  return found.substr(1);
}

bool Arguments::take(const char *keyword)
{
  if (!more()) return false;
  if (asked_at_ != next_) asked_.clear();
  asked_at_ = next_;
  const std::string word = keyword;
  if ((", " + asked_ + ",").find(", " + word + ",") == std::string::npos)
    asked_ += (asked_.empty() ? "" : ", ") + word;
  if (words_[next_] != word) return false;
  ++next_;
  return true;
}

std::string Arguments::word(const std::string &what)
{
  if (!more()) fail("too few arguments: " + what + " is missing");
  return words_[next_++];
}

static bool parse(const std::string &s, double &value)
{
  char *end = nullptr;
  value = strtod(s.c_str(), &end);
  return !s.empty() && *end == '\0' && std::isfinite(value);
}

bool Arguments::next_is_number() const
{
  double value;
  return more() && parse(words_[next_], value);
}

double Arguments::number(const std::string &what) { return number_in(word(what), what); }

double Arguments::number_in(const std::string &word, const std::string &what) const
{
  double value;
  if (!parse(word, value)) fail(what + " must be a number, not '" + word + "'");
  return value;
}

double Arguments::positive(const std::string &what)
{
  const double v = number(what);
  if (!(v > 0.0)) fail(what + " is " + text(v) + ", must be > 0");
  return v;
}

double Arguments::non_negative(const std::string &what)
{
  const double v = number(what);
  if (!(v >= 0.0)) fail(what + " is " + text(v) + ", must be >= 0");
  return v;
}

double Arguments::within(const std::string &what, double lo, double hi)
{
  const double v = number(what);
  if (!(v >= lo && v <= hi))
    fail(what + " is " + text(v) + ", must be from " + text(lo) + " to " + text(hi));
  return v;
}

int Arguments::integer(const std::string &what, int lo, int hi)
{
  const double v = number(what);
  if (v != std::floor(v) || v < lo || v > hi)
    fail(what + " is " + text(v) + ", must be a whole number from " + std::to_string(lo) + " to " +
         std::to_string(hi));
  return static_cast<int>(v);
}

int Arguments::choice(const std::string &what, const std::vector<std::string> &allowed)
{
  const std::string s = word(what);
  const auto at = std::find(allowed.begin(), allowed.end(), s);
  if (at == allowed.end()) fail(what + " is '" + s + "', must be one of: " + joined(allowed));
  return static_cast<int>(at - allowed.begin());
}

// Returns the end of a message, which suggests the word from the list "a, b, c" that the user
// probably meant.
static std::string meant(const std::string &wrong, const std::string &list)
{
  std::set<std::string> known;
  for (const std::string &word : words_of(list)) known.insert(word.substr(0, word.find(',')));
  if (known.empty()) return "";
  const std::string near = near_first(wrong, known).front();
  return distance(wrong, near) > near.size() / 3 ? "" : "; did you mean '" + near + "'?";
}

void Arguments::unknown(const std::string &allowed)
{
  const std::string &word = words_[next_];
  fail("unknown keyword or one argument too many: '" + word + "'" + meant(word, allowed) +
       "; known: " + allowed);
}

}    // namespace bearing
