// SPDX-License-Identifier: GPL-2.0-or-later
#include "find_data.h"

#include "../core/settings/data_table.h"
#include "../core/settings/written.h"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace fs = std::filesystem;

namespace bearing {

static Data data_file(const fs::path &file)
{
  Data data{"", "'" + file.string() + "'", ""};
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  data.lines = all.str();
  // some editors write a byte order mark
  if (data.lines.compare(0, 3, "\xef\xbb\xbf") == 0)
    data.complaint = data.label + " starts with a byte order mark: save it as UTF-8 without one";
  return data;
}

// A message lists all names if there are at most `longest_list` of them; otherwise it lists only
// the `nearest_names` names that are most similar to the given one.
static constexpr size_t longest_list = 12, nearest_names = 6;

Data find_data(std::string folder, std::string name)
{
  std::error_code ec;
  const fs::path given = name;
  if (name.find('/') != std::string::npos && fs::is_regular_file(given, ec)) {
    folder = given.parent_path().string();
    name = given.filename().string();
  }
  const fs::path file = fs::path(folder) / name;
  std::set<std::string> names;
  if (file.extension() != ".csv") {
    if (fs::is_regular_file(file, ec)) return data_file(file);
    if (fs::exists(fs::symlink_status(file, ec)))
      return {"'" + file.string() + "' is not a file but a folder, a pipe or a broken link"};
  }
  for (const DataTable &table : tables_of(folder)) {
    if (!table.complaint().empty()) return {table.complaint()};
    if (table.has(name))
      return {"", "'" + name + "' of '" + table.file() + "'", joined(table.commands(name), "\n")};
    names.merge(table.names());
  }
  for (fs::directory_iterator it(folder, ec), end; !ec && it != end; it.increment(ec))
    if (it->path().extension() != ".csv") names.insert(it->path().filename().string());
  std::vector<std::string> near = near_first(name, names);
  if (near.size() > longest_list) {
    near.resize(nearest_names);
    near.push_back(std::to_string(names.size()) + " in all");
  }
  return {"there is no '" + name + "' in folder " + folder + "; there is: " +
          (near.empty() ? "nothing (run from the folder that holds it, or give 'inputs FOLDER')"
                        : joined(near))};
}

}    // namespace bearing
