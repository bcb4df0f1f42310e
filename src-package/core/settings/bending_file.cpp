// SPDX-License-Identifier: GPL-2.0-or-later
#include "bending_file.h"

#include <cmath>
#include <map>
#include <sstream>

using raceway::ShaftModes;

namespace bearing {

static constexpr const char *title = "raceway-shaft 1", *units = "m kg s N rad";
static constexpr int most_modes = 100, most_stations = 1000;
static constexpr double even = 1e-9;    // allowed asymmetry relative to the largest value

namespace {

struct Line {
  int number;
  std::vector<double> values;
};

// Groups the lines of a file by their first words and creates error messages about them.
class Reader {
 public:
  Reader(const Arguments &args, const std::string &name, const std::string &content) :
      args_(args), name_(name)
  {
    std::istringstream in(content);
    std::string line;
    if (!std::getline(in, line) || plain(line) != title)
      fail("line 1 is '" + line.substr(0, 40) + "', must be '" + title + "'");
    for (int n = 2; std::getline(in, line); ++n) read(plain(line.substr(0, line.find('#'))), n);
    if (!units_) fail(std::string("has no line 'units ") + units + "'");
  }

  // Returns the values of the single line that begins with this word. Their number and range are
  // checked.
  std::vector<double> one(const std::string &word, size_t count, double least, double most)
  {
    const std::vector<Line> &found = all(word, 1);
    check(word, found[0], count, least, most);
    return found[0].values;
  }
  const std::vector<Line> &all(const std::string &word, size_t count)
  {
    const std::vector<Line> &found = lines_[word];
    if (found.size() != count)
      fail("has " + std::to_string(found.size()) + " lines '" + word + "', must have " +
           std::to_string(count));
    return found;
  }
  const std::vector<Line> &all(const std::string &word) { return lines_[word]; }
  void check(const std::string &word, const Line &line, size_t count, double least, double most)
  {
    if (line.values.size() != count)
      fail("line " + std::to_string(line.number) + ": '" + word + "' has " +
           std::to_string(line.values.size()) + " numbers, must have " + std::to_string(count));
    for (double v : line.values)
      if (!(v >= least && v <= most))
        fail("line " + std::to_string(line.number) + ": '" + word + "' is " + text(v) +
             ", must be from " + text(least) + " to " + text(most));
  }
  [[noreturn]] void fail(const std::string &why) const { args_.fail("'" + name_ + "' " + why); }

 private:
  static std::string plain(const std::string &line)    // without leading and trailing blanks
  {
    const char *blanks = " \t\r";
    const size_t first = line.find_first_not_of(blanks);
    return first == std::string::npos
               ? ""
               : line.substr(first, line.find_last_not_of(blanks) - first + 1);
  }
  void read(const std::string &line, int number)
  {
    std::istringstream words(line);
    std::string word, rest;
    if (!(words >> word)) return;
    if (word == "units") {
      if (line != std::string("units ") + units)
        fail("line " + std::to_string(number) + " is '" + line + "', must be 'units " + units +
             "'");
      units_ = true;
      return;
    }
    const auto known = {"mass",          "centre",     "inertia",
                        "modes",         "modal_mass", "modal_stiffness",
                        "modal_damping", "gyroscopic", "station"};
    std::string list;
    bool is_known = false;
    for (const char *k : known) {
      is_known = is_known || word == k;
      list += std::string(", ") + k;
    }
    if (!is_known)
      fail("line " + std::to_string(number) + ": unknown word '" + word + "'; known: units" + list);
    Line read = {number, {}};
    for (std::string value; words >> value;) {
      char *end;
      read.values.push_back(strtod(value.c_str(), &end));
      if (*end != '\0' || !std::isfinite(read.values.back()))
        fail("line " + std::to_string(number) + ": '" + value + "' is not a finite number");
    }
    lines_[word].push_back(read);
  }

  const Arguments &args_;
  std::string name_;
  std::map<std::string, std::vector<Line>> lines_;
  bool units_ = false;
};

}    // namespace

static void read_gyroscopic(Reader &file, size_t n, double axial, ShaftModes &m)
{
  double most = 0.0;
  for (const Line &row : file.all("gyroscopic", n + 1)) {
    file.check("gyroscopic", row, n + 1, -1e9, 1e9);
    for (double v : row.values) {
      m.gyroscopic.push_back(v);
      most = std::max(most, std::fabs(v));
    }
  }
  for (size_t i = 0; i <= n; ++i)
    for (size_t k = 0; k < i; ++k)
      if (std::fabs(m.g(i, k) - m.g(k, i)) > even * most)
        file.fail("'gyroscopic' is not symmetric: " + text(m.g(i, k)) + " in row " +
                  std::to_string(i + 1) + ", column " + std::to_string(k + 1) + ", but " +
                  text(m.g(k, i)) + " across");
  if (std::fabs(m.g(0, 0) - axial) > 1e-6 * axial)
    file.fail("'gyroscopic' begins with " + text(m.g(0, 0)) +
              ", must be the inertia about the axis, " + text(axial));
}

static void read_stations(Reader &file, size_t n, double centre, ShaftModes &m)
{
  const std::vector<Line> &stations = file.all("station");
  if (stations.size() < 2 || stations.size() > most_stations)
    file.fail("has " + std::to_string(stations.size()) + " lines 'station', must have 2 to " +
              std::to_string(most_stations));
  double last = -HUGE_VAL;
  for (const Line &one : stations) {
    file.check("station", one, 2 * n + 1, -1e6, 1e6);
    if (!(one.values[0] > last))
      file.fail("line " + std::to_string(one.number) + ": station at " + text(one.values[0]) +
                " m, must be beyond the one before it");
    last = one.values[0];
    ShaftModes::Station s = {last - centre, {}, {}};
    for (size_t k = 0; k < n; ++k) {
      s.moved.push_back(one.values[2 * k + 1]);
      s.tilted.push_back(one.values[2 * k + 2]);
    }
    m.stations.push_back(s);
  }
}

BendingShaft read_bending_shaft(const Arguments &args, const std::string &name)
{
  static constexpr double tiny = 1e-15, huge = 1e18;
  const std::optional<std::string> content = args.content(name);
  if (!content) args.fail("cannot read '" + name + "'");
  Reader file(args, name, *content);
  BendingShaft s;
  s.mass = file.one("mass", 1, tiny, huge)[0];
  s.centre = file.one("centre", 1, -huge, huge)[0];
  const std::vector<double> inertia = file.one("inertia", 2, tiny, huge);
  s.inertia.axial = inertia[0];
  s.inertia.transverse = inertia[1];
  if (s.inertia.axial > 2.0 * s.inertia.transverse)
    file.fail("'inertia' is " + text(inertia[0]) + " " + text(inertia[1]) +
              ": no body has more than twice as much about its axis as across it");
  const double modes = file.one("modes", 1, 1, most_modes)[0];
  const size_t n = static_cast<size_t>(modes);
  if (double(n) != modes) file.fail("'modes' is " + text(modes) + ", must be a whole number");
  s.modes.mass = file.one("modal_mass", n, tiny, huge);
  s.modes.stiffness = file.one("modal_stiffness", n, tiny, huge);
  s.modes.damping = file.one("modal_damping", n, 0.0, huge);
  read_gyroscopic(file, n, s.inertia.axial, s.modes);
  read_stations(file, n, s.centre, s.modes);
  return s;
}

}    // namespace bearing
