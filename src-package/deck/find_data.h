// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the data of a bearing or an oil, either in a file in a folder or in a row of a table
// FOLDER/*.csv.
#pragma once

#include <string>

namespace bearing {

struct Data {
  std::string complaint = {}, label = {}, lines = {};
};

// `name` may also be the path of a file if it contains a '/'. Because the function reads files, it
// should be called on one rank only.
Data find_data(std::string folder, std::string name);

}    // namespace bearing
