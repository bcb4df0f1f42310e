// SPDX-License-Identifier: GPL-2.0-or-later
// Tables that replace data files, FOLDER/*.csv. Each row stands for a data file that has the name
// of the row. The format is described in docs/catalogue.rst.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace bearing {

class DataTable {
 public:
  explicit DataTable(const std::string &file);

  const std::string &file() const { return file_; }
  const std::string &complaint() const { return complaint_; }    // empty if the table is usable
  std::set<std::string> names() const;                           // names of the rows
  std::set<std::string> variables() const;                       // variables of all rows
  bool has(const std::string &name) const { return rows_.count(name) > 0; }
  std::vector<std::string> commands(const std::string &name) const;    // as in a data file

 private:
  std::string file_, complaint_;
  std::vector<std::string> common_;     // commands shared by all rows
  std::vector<std::string> columns_;    // variables
  std::map<std::string, std::vector<std::string>> rows_;

  void read_row(const std::string &line, int number);
};

// Returns NAME if the line is of the form `variable NAME ...`, and an empty string otherwise.
std::string variable_of(const std::string &line);

std::vector<DataTable> tables_of(const std::string &folder);    // sorted by file name

// Returns the given names, starting with the one that is most similar to `name`.
std::vector<std::string> near_first(const std::string &name, const std::set<std::string> &names);

// Returns the Levenshtein distance, i.e. the number of letters that must be changed, added or
// removed to turn one word into the other.
size_t distance(const std::string &a, const std::string &b);

}    // namespace bearing
