// SPDX-License-Identifier: GPL-2.0-or-later
// Tables of a deck's variables (inputs/variables): defaults, units and allowed values.
#ifndef BEARING_VARIABLE_TABLE_H
#define BEARING_VARIABLE_TABLE_H

#include "../core/settings/arguments.h"
#include "bearing_compat.h"

namespace bearing {

// Checks one value against the remaining words of `args`: LO HI [whole] [or V] [advice TEXT], or
// one_of WORD .... Stops the run with a message that names the value as `label`.
void check_range(Arguments &args, const std::string &label, const std::string &value);

class VariableTable : protected LAMMPS_NS::Pointers {
 public:
  // Reads a file with a row `variable NAME index DEFAULT|needed [unit U] [range ...|one_of ...]`
  // for each variable; an error of the command `args` if the file is missing. Collective.
  VariableTable(LAMMPS_NS::LAMMPS *lmp, const Arguments &args, const std::string &file);

  std::vector<std::string> missing() const;    // needed variables that the deck has not set
  void check() const;    // sets defaults of undefined variables, then checks all

 private:
  struct Row {
    std::string name, label, value;    // value: the default, empty if needed
    std::vector<std::string> range;
  };
  std::vector<Row> rows_;

  Row read(const std::string &line, const std::string &place) const;
  bool there(const std::string &name) const;
};

}    // namespace bearing

#endif
