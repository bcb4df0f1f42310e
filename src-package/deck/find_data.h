// SPDX-License-Identifier: GPL-2.0-or-later
// Data of bearings and oils: a file in a folder, or a row of a table FOLDER/*.csv.
#ifndef BEARING_FIND_DATA_H
#define BEARING_FIND_DATA_H

#include <set>
#include <string>
#include <vector>

namespace bearing {

struct Data {
  std::string complaint = {}, label = {}, commands = {};
  std::set<std::string> variables = {};    // set by the file itself, not by its includes
};

// Commands of the host: for a file, its include. Reads files: call it on one rank.
Data find_data(const std::string &folder, const std::string &name);

std::string joined(const std::vector<std::string> &names, const char *between = ", ");

}    // namespace bearing

#endif
