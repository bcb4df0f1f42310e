// SPDX-License-Identifier: GPL-2.0-or-later
// The styles for a LAMMPS with plugins. raceway_plugin.so loads this object after it has checked
// the host.
#include "bearing_styles.h"
#include "plugin_interface.h"

using namespace LAMMPS_NS;

namespace {

template <class T> void *make_pair_style(void *lmp)
{
  return static_cast<Pair *>(new T(static_cast<LAMMPS *>(lmp)));
}
template <class T> void *make_fix(void *lmp, int narg, char **arg)
{
  return static_cast<Fix *>(new T(static_cast<LAMMPS *>(lmp), narg, arg));
}
template <class T> void *make_compute(void *lmp, int narg, char **arg)
{
  return static_cast<Compute *>(new T(static_cast<LAMMPS *>(lmp), narg, arg));
}
template <class T> void *make_command(void *lmp)
{
  return static_cast<Command *>(new T(static_cast<LAMMPS *>(lmp)));
}

struct Registry {
  void *lmp;
  PluginRegister add;
  PluginStyle style;

  template <class T> void pair(const char *name)
  {
    tell("pair", name).creator.v1 = &make_pair_style<T>, call();
  }
  template <class T> void fix(const char *name)
  {
    tell("fix", name).creator.v2 = &make_fix<T>, call();
  }
  template <class T> void compute(const char *name)
  {
    tell("compute", name).creator.v2 = &make_compute<T>, call();
  }
  template <class T> void command(const char *name)
  {
    tell("command", name).creator.v1 = &make_command<T>, call();
  }

 private:
  PluginStyle &tell(const char *kind, const char *name)
  {
    style.style = kind;
    style.name = style.info = name;    // LAMMPS prints: Loading plugin: INFO by AUTHOR
    return style;
  }
  void call() { add(&style, lmp); }
};

}    // namespace

extern "C" __attribute__((visibility("default"))) void
raceway_register_plugin(void *lmp, void *handle, void *add)
{
  PluginStyle style = {};
  style.version = static_cast<LAMMPS *>(lmp)->version;
  style.author = "Raceway";
  style.handle = handle;
  Registry registry{lmp, reinterpret_cast<PluginRegister>(add), style};
  register_bearing_styles(registry);
}
