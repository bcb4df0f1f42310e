// SPDX-License-Identifier: GPL-2.0-or-later
// A program that stands in for LAMMPS of any version with any MPI library. It exports the symbols
// that raceway_plugin.so inspects before it loads the styles:
//   fake_lammps PLUGIN VERSION MPI_NAME [BYTES_OF_TAGINT]
// The exit code is 0 if the plugin returns without having registered anything.
#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>

static int version, registered, tagint = 4;
static const char *mpi;

extern "C" {
int lammps_version(void *) { return version; }
int lammps_extract_setting(void *, const char *name)
{
  if (strcmp(name, "tagint") == 0) return tagint;
  return strcmp(name, "bigint") == 0 ? 8 : 0;
}
int MPI_Get_library_version(char *text, int *length)
{
  strcpy(text, mpi);
  *length = static_cast<int>(strlen(mpi));
  return 0;
}
}

static void count(void *, void *) { ++registered; }

int main(int argc, char **argv)
{
  version = atoi(argv[2]);
  mpi = argv[3];
  if (argc > 4) tagint = atoi(argv[4]);
  void *plugin = dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL);
  if (!plugin) return fprintf(stderr, "%s\n", dlerror()), 2;
  using Init = void (*)(void *, void *, void *);
  const Init init = reinterpret_cast<Init>(dlsym(plugin, "lammpsplugin_init"));
  if (!init) return fprintf(stderr, "%s\n", dlerror()), 2;
  init(nullptr, plugin, reinterpret_cast<void *>(&count));
  return registered;
}
