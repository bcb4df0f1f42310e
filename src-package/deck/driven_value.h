// SPDX-License-Identifier: GPL-2.0-or-later
// A number, an equal-style variable v_NAME evaluated once a step, or an atom-style one with a value
// for every ring.
#ifndef BEARING_DRIVEN_VALUE_H
#define BEARING_DRIVEN_VALUE_H

#include "arguments.h"

namespace bearing {

class DrivenValue {
 public:
  // The next word of a command: a number or v_NAME; with `each_ring` that may be an atom-style
  // variable.
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

  bool is_variable() const { return !name_.empty(); }

  // Before a run: does the variable exist?
  void check(LAMMPS_NS::LAMMPS *lmp, const std::string &command)
  {
    if (!is_variable()) return;
    index_ = lmp->input->variable->find(const_cast<char *>(name_.c_str()));
    by_atom_ = each_ring_ && index_ >= 0 && lmp->input->variable->atomstyle(index_);
    if (index_ < 0 || !(by_atom_ || lmp->input->variable->equalstyle(index_)))
      BRG_ALL_OF(lmp, command + ": there is no " + style() + " variable '" + name_ + "'");
  }

  bool by_atom() const { return by_atom_; }    // after check()

  double now(LAMMPS_NS::LAMMPS *lmp) const
  {
    return !is_variable() ? value_ : by_atom_ ? 0.0 : lmp->input->variable->compute_equal(index_);
  }

  // of every owned atom of a group, 0 for others
  std::vector<double> of_atoms(LAMMPS_NS::LAMMPS *lmp, int igroup) const
  {
    std::vector<double> values(lmp->atom->nlocal + 1, 0.0);
    lmp->input->variable->compute_atom(index_, igroup, values.data(), 1, 0);
    return values;
  }

  const std::string &name() const { return name_; }

 private:
  const char *style() const { return each_ring_ ? "equal- or atom-style" : "equal-style"; }

  double value_ = 0.0;
  std::string name_;
  int index_ = -1;
  bool each_ring_ = false, by_atom_ = false;
};

}    // namespace bearing

#endif
