// SPDX-License-Identifier: GPL-2.0-or-later
// Registers styles in LIGGGHTS: add.pair<Class>("name"), ...
#pragma once

#include "bearing_compat.h"
#include "lammps.h"

#include <map>

namespace {

using namespace LAMMPS_NS;

using FixCreator = Fix *(*)(LAMMPS *, int, char **);
using ComputeCreator = Compute *(*)(LAMMPS *, int, int, char **);
using CommandCreator = void (*)(LAMMPS *, int, char **);

// These maps are not public in LIGGGHTS 3.8. They are accessed through an explicit instantiation,
// which is allowed to name a private member.
template <class Tag, typename Tag::type Member> struct Reach {
  friend typename Tag::type member(Tag) { return Member; }
};
struct FixMap {
  using type = std::map<std::string, FixCreator> *Modify::*;
  friend type member(FixMap);
};
struct ComputeMap {
  using type = std::map<std::string, ComputeCreator> *Modify::*;
  friend type member(ComputeMap);
};
struct CommandMap {
  using type = std::map<std::string, CommandCreator> *Input::*;
  friend type member(CommandMap);
};
template struct Reach<FixMap, &Modify::fix_map>;
template struct Reach<ComputeMap, &Modify::compute_map>;
template struct Reach<CommandMap, &Input::command_map>;

template <class T> Pair *make_pair_style(LAMMPS *lmp) { return new T(lmp); }
template <class T> Fix *make_fix(LAMMPS *lmp, int narg, char **arg)
{
  return new T(lmp, narg, arg);
}
template <class T> Compute *make_compute(LAMMPS *lmp, int iarg, int narg, char **arg)
{
  return new T(lmp, iarg, narg, arg);
}
template <class T> void run_command(LAMMPS *lmp, int narg, char **arg)
{
  T command(lmp);
  command.command(narg, arg);
}

struct Registry {
  LAMMPS *lmp;
  template <class T> void pair(const char *name)
  {
    (*lmp->force->pair_map)[name] = &make_pair_style<T>;
  }
  template <class T> void fix(const char *name)
  {
    (*(lmp->modify->*member(FixMap())))[name] = &make_fix<T>;
  }
  template <class T> void compute(const char *name)
  {
    (*(lmp->modify->*member(ComputeMap())))[name] = &make_compute<T>;
  }
  template <class T> void command(const char *name)
  {
    if (lmp->input) (*(lmp->input->*member(CommandMap())))[name] = &run_command<T>;
  }
};

}    // namespace
