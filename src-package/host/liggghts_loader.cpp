// SPDX-License-Identifier: GPL-2.0-or-later
// Puts the styles into an unmodified LIGGGHTS: this shared object comes before libliggghts in the search
// order and so answers for LAMMPS::post_create(), which the host calls when it starts and after every
// `clear`. Link it (build/liggghts), preload it, or load it from Python with RTLD_GLOBAL.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "bearing_styles.h"
#include "lammps.h"

#include <dlfcn.h>
#include <map>

using namespace LAMMPS_NS;

namespace {

using FixCreator = Fix *(*) (LAMMPS *, int, char **);
using ComputeCreator = Compute *(*) (LAMMPS *, int, int, char **);
using CommandCreator = void (*)(LAMMPS *, int, char **);

// These maps are not public in LIGGGHTS 3.8; naming a member in an explicit instantiation is allowed.
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
template <class T> Fix *make_fix(LAMMPS *lmp, int narg, char **arg) { return new T(lmp, narg, arg); }
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
  template <class T> void pair(const char *name) { (*lmp->force->pair_map)[name] = &make_pair_style<T>; }
  template <class T> void fix(const char *name) { (*(lmp->modify->*member(FixMap())))[name] = &make_fix<T>; }
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

// Also callable by hand on a LAMMPS object made elsewhere.
extern "C" __attribute__((visibility("default"))) void raceway_register(void *lmp)
{
  Registry registry{static_cast<LAMMPS *>(lmp)};
  register_bearing_styles(registry);
}

__attribute__((visibility("default"))) void LAMMPS::post_create()
{
  using Function = void (*)(LAMMPS *);
  static const Function next = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (!next) {
    fprintf(stderr, "raceway: this is not the LIGGGHTS it was built for: LAMMPS::post_create() not found\n");
    abort();
  }
  // the host ends a failed rank with MPI_Abort, which drops a buffered message: keep whole lines
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  raceway_register(this);
  next(this);
}
