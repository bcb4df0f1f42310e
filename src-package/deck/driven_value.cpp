// SPDX-License-Identifier: GPL-2.0-or-later
#include "../core/settings/driven_value.h"

#include "bearing_compat.h"

using namespace LAMMPS_NS;

namespace bearing {

void DrivenValue::check(LAMMPS *lmp, const std::string &command)
{
  if (!is_variable()) return;
  index_ = lmp->input->variable->find(const_cast<char *>(name_.c_str()));
  by_atom_ = each_ring_ && index_ >= 0 && lmp->input->variable->atomstyle(index_);
  if (index_ < 0 || !(by_atom_ || lmp->input->variable->equalstyle(index_)))
    stop_run(lmp, command + ": there is no " + style() + " variable '" + name_ + "'");
}

double DrivenValue::now(LAMMPS *lmp) const
{
  return !is_variable() ? value_ : by_atom_ ? 0.0 : lmp->input->variable->compute_equal(index_);
}

std::vector<double> DrivenValue::of_atoms(LAMMPS *lmp, int igroup) const
{
  std::vector<double> values(lmp->atom->nlocal + 1, 0.0);
  lmp->input->variable->compute_atom(index_, igroup, values.data(), 1, 0);
  return values;
}

}    // namespace bearing
