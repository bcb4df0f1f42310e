// SPDX-License-Identifier: GPL-2.0-or-later
#include "../core/settings/arguments.h"
#include "agree.h"
#include "bearing_compat.h"

namespace bearing {

void stop_run(LAMMPS_NS::LAMMPS *lmp, const std::string &why)
{
  BRG_ALL_OF(lmp, why);
  std::abort();    // this line is not reached, because the error above ends the run
}

bool is_first_rank(LAMMPS_NS::LAMMPS *lmp) { return lmp->comm->me == 0; }

std::string of_first_rank(LAMMPS_NS::LAMMPS *lmp, const std::string &text)
{
  return agree(text, lmp->world);
}

std::optional<std::string> host_variable(LAMMPS_NS::LAMMPS *lmp, const std::string &name)
{
  char *const letters = const_cast<char *>(name.c_str());
  LAMMPS_NS::Variable &variables = *lmp->input->variable;
  const char *value = variables.find(letters) >= 0 ? variables.retrieve(letters) : nullptr;
  return value ? std::optional<std::string>(value) : std::nullopt;
}

}    // namespace bearing
