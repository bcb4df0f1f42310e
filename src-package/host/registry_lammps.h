// SPDX-License-Identifier: GPL-2.0-or-later
// Registers styles in a LAMMPS without plugins: add.pair<Class>("name"), ...
#pragma once

#include "bearing_compat.h"
#include "lammps.h"

#include <map>

namespace {

using namespace LAMMPS_NS;

template <class T> Pair *make_pair_style(LAMMPS *lmp) { return new T(lmp); }
template <class T> Fix *make_fix(LAMMPS *lmp, int narg, char **arg)
{
  return new T(lmp, narg, arg);
}
template <class T> Compute *make_compute(LAMMPS *lmp, int narg, char **arg)
{
  return new T(lmp, narg, arg);
}
template <class T> Command *make_command(LAMMPS *lmp) { return new T(lmp); }

struct Registry {
  LAMMPS *lmp;
  template <class T> void pair(const char *name)
  {
    (*lmp->force->pair_map)[name] = &make_pair_style<T>;
  }
  template <class T> void fix(const char *name) { (*lmp->modify->fix_map)[name] = &make_fix<T>; }
  template <class T> void compute(const char *name)
  {
    (*lmp->modify->compute_map)[name] = &make_compute<T>;
  }
  template <class T> void command(const char *name)
  {
    (*lmp->input->command_map)[name] = &make_command<T>;
  }
};

}    // namespace
