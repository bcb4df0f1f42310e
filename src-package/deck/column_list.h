// SPDX-License-Identifier: GPL-2.0-or-later
// Interface for the columns of a compute in a dump, or of a fix in fix print, as used by the
// command bearing_dump.
#pragma once

#include <string>
#include <vector>

namespace bearing {

class ColumnList {
 public:
  struct Item {
    std::string name, format;
  };
  virtual std::vector<Item> columns() const = 0;

 protected:
  ~ColumnList() = default;    // styles are never deleted through this interface
};

}    // namespace bearing
