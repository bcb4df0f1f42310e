// SPDX-License-Identifier: GPL-2.0-or-later
#include "../core/settings/arguments.h"
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
  std::string all = text;
  int n = static_cast<int>(all.size());
  MPI_Bcast(&n, 1, MPI_INT, 0, lmp->world);
  all.resize(n);
  MPI_Bcast(&all[0], n, MPI_CHAR, 0, lmp->world);
  return all;
}

std::optional<std::string> host_variable(LAMMPS_NS::LAMMPS *lmp, const std::string &name)
{
  char *const letters = const_cast<char *>(name.c_str());
  LAMMPS_NS::Variable &variables = *lmp->input->variable;
  const char *value = variables.find(letters) >= 0 ? variables.retrieve(letters) : nullptr;
  return value ? std::optional<std::string>(value) : std::nullopt;
}

}    // namespace bearing
