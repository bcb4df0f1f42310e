// SPDX-License-Identifier: GPL-2.0-or-later
#include "data_table.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace bearing {

static std::vector<std::string> cells(const std::string &line)
{
  std::vector<std::string> found(1);
  for (const char c : line)
    if (c == ',') found.emplace_back();
    else found.back() += c;
  return found;
}

DataTable::DataTable(const std::string &file) : file_(file)
{
  std::ifstream in(file);
  if (!in) complaint_ = "cannot read table '" + file + "'";
  bool head = true;
  int number = 0;
  for (std::string line; complaint_.empty() && std::getline(in, line);) {
    if (++number == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0) line.erase(0, 3);    // UTF-8 BOM
    // spreadsheet programs end lines with a carriage return and pad short lines with commas
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.find_first_not_of(" ,") == std::string::npos || line[0] == '#') continue;
    if (!head) {
      read_row(line, number);
    } else if (line.compare(0, 5, "name,") == 0) {
      head = false;
      columns_ = cells(line);
    } else {
      common_.push_back(line.substr(0, line.find_last_not_of(',') + 1));
    }
  }
  if (complaint_.empty() && head)
    complaint_ = "table '" + file + "' has no heading that begins with name,";
  if (!complaint_.empty()) return;
  columns_.erase(std::find(columns_.begin(), columns_.end(), "source"), columns_.end());
  columns_.erase(columns_.begin());
}

void DataTable::read_row(const std::string &line, int number)
{
  std::vector<std::string> row = cells(line);
  const std::string place = "table '" + file_ + "', line " + std::to_string(number) + ": ";
  if (row.size() != columns_.size())
    complaint_ = place + std::to_string(row.size()) + " cells, must be " +
                 std::to_string(columns_.size()) + " as in the heading";
  else if (rows_.count(row[0])) complaint_ = place + "a second row '" + row[0] + "'";
  else rows_[row[0]] = {row.begin() + 1, row.end()};
}

std::set<std::string> DataTable::names() const
{
  std::set<std::string> found;
  for (const auto &row : rows_) found.insert(row.first);
  return found;
}

std::set<std::string> DataTable::variables() const
{
  std::set<std::string> found(columns_.begin(), columns_.end());
  for (const std::string &line : common_) found.insert(variable_of(line));
  found.erase("");
  return found;
}

std::vector<std::string> DataTable::commands(const std::string &name) const
{
  std::vector<std::string> found;
  const std::vector<std::string> &row = rows_.at(name);
  for (size_t k = 0; k < columns_.size(); ++k)
    if (!row[k].empty()) found.push_back("variable " + columns_[k] + " index " + row[k]);
  found.insert(found.end(), common_.begin(), common_.end());
  return found;
}

std::string variable_of(const std::string &line)
{
  std::istringstream words(line);
  std::string command, name;
  return words >> command >> name && command == "variable" ? name : "";
}

std::vector<DataTable> tables_of(const std::string &folder)
{
  std::error_code ec;
  std::set<fs::path> files;
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() == ".csv") files.insert(it->path());
  std::vector<DataTable> found;
  for (const fs::path &file : files) found.emplace_back(file.string());
  return found;
}

std::vector<std::string> near_first(const std::string &name, const std::set<std::string> &names)
{
  std::vector<std::string> order(names.begin(), names.end());
  std::stable_sort(order.begin(), order.end(), [&](const std::string &a, const std::string &b) {
    return distance(name, a) < distance(name, b);
  });
  return order;
}

size_t distance(const std::string &a, const std::string &b)
{
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    size_t diagonal = row[0];
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t change = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row[b.size()];
}

}    // namespace bearing
