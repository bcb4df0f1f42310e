// SPDX-License-Identifier: GPL-2.0-or-later
// A number, an equal-style variable v_NAME that is evaluated once per step, or an atom-style
// variable with one value per ring.
#pragma once

#include "arguments.h"

#include <cmath>

namespace bearing {

class DrivenValue {
 public:
  // Reads the next word of a command, which is a number or v_NAME. If `each_ring` is true, the
  // variable may also be atom-style.
  static DrivenValue read(Arguments &args, const std::string &what, bool each_ring = false)
  {
    DrivenValue d;
    d.each_ring_ = each_ring;
    if (args.next_is_number()) {
      d.value_ = args.number(what);
      return d;
    }
    const std::string w = args.word(what);
    if (w.compare(0, 2, "v_") != 0 || w.size() < 3)
      args.fail(what + " must be a number or an " + d.style() + " variable v_NAME, not '" + w +
                "'");
    d.name_ = w.substr(2);
    return d;
  }

  static DrivenValue constant(double value)
  {
    DrivenValue d;
    d.value_ = value;
    return d;
  }

  // Returns the number, or NAN if the value is a variable.
  double constant_value() const { return name_.empty() ? value_ : NAN; }
  bool is_zero() const { return name_.empty() && value_ == 0.0; }
  bool is_variable() const { return !name_.empty(); }

  // Checks before a run that the variable exists.
  void check(LAMMPS_NS::LAMMPS *, const std::string &command);

  bool by_atom() const { return by_atom_; }    // valid after check()

  double now(LAMMPS_NS::LAMMPS *) const;

  // Returns the values for the owned atoms of a group, and 0 for all other owned atoms.
  std::vector<double> of_atoms(LAMMPS_NS::LAMMPS *, int igroup) const;

  const std::string &name() const { return name_; }

 private:
  const char *style() const { return each_ring_ ? "equal- or atom-style" : "equal-style"; }

  double value_ = 0.0;
  std::string name_;
  int index_ = -1;
  bool each_ring_ = false, by_atom_ = false;
};

}    // namespace bearing
