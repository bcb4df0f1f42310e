// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of data files, FOLDER/*.csv: a row stands for a file of its name. docs/catalogue.rst has
// the format.
#ifndef BEARING_DATA_TABLE_H
#define BEARING_DATA_TABLE_H

#include <map>
#include <set>
#include <string>
#include <vector>

namespace bearing {

class DataTable {
 public:
  explicit DataTable(const std::string &file);

  const std::string &file() const { return file_; }
  const std::string &complaint() const { return complaint_; }    // why it cannot be used, or empty
  std::set<std::string> names() const;                           // of the rows
  std::set<std::string> variables() const;    // those that some row or all rows set
  bool has(const std::string &name) const { return rows_.count(name) > 0; }
  std::set<std::string> variables(const std::string &name) const;      // those that a row sets
  std::vector<std::string> commands(const std::string &name) const;    // a deck's, of a row

 private:
  std::string file_, complaint_;
  std::vector<std::string> common_;     // commands for all rows
  std::vector<std::string> columns_;    // variables
  std::map<std::string, std::vector<std::string>> rows_;

  void read_row(const std::string &line, int number);
};

// The variable of a line `variable NAME ...`; empty of any other line
std::string variable_of(const std::string &line);

std::vector<DataTable> tables_of(const std::string &folder);    // by the names of their files

// The names, those that differ from `name` by a few letters first
std::vector<std::string> near_first(const std::string &name, const std::set<std::string> &names);

// How many letters must be changed, added or taken away to make one word of the other
size_t distance(const std::string &a, const std::string &b);

}    // namespace bearing

#endif
