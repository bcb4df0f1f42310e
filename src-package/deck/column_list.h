// SPDX-License-Identifier: GPL-2.0-or-later
// What a compute has for a dump, or a fix for fix print: the command bearing_columns asks it.
#ifndef BEARING_COLUMN_LIST_H
#define BEARING_COLUMN_LIST_H

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
  ~ColumnList() = default;    // nobody owns a style by this name
};

}    // namespace bearing

#endif
