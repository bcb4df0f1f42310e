// SPDX-License-Identifier: GPL-2.0-or-later
// Loads the styles into an unmodified LIGGGHTS, or into a LAMMPS without plugins. This shared
// object precedes the host's library in the symbol search order and thereby interposes
// LAMMPS::post_create(), which the host calls when it starts and after every `clear`. The object
// can be linked (build/liggghts, build/lammps), preloaded, or loaded from Python with RTLD_GLOBAL.
#ifndef _GNU_SOURCE
#define _GNU_SOURCE
#endif
#include "bearing_styles.h"
#if BEARING_IS_LIGGGHTS
#include "registry_liggghts.h"
#else
#include "registry_lammps.h"
#endif

#include <dlfcn.h>

// Can also be called directly for a LAMMPS object that was created elsewhere.
extern "C" __attribute__((visibility("default"))) void raceway_register(void *lmp)
{
  Registry registry{static_cast<LAMMPS *>(lmp)};
  register_bearing_styles(registry);
}

__attribute__((visibility("default"))) void LAMMPS::post_create()
{
  using Function = void (*)(LAMMPS *);
  static const Function next =
      reinterpret_cast<Function>(dlsym(RTLD_NEXT, "_ZN9LAMMPS_NS6LAMMPS11post_createEv"));
  if (!next) {
    fprintf(stderr,
            "raceway: this is not the host it was built for: LAMMPS::post_create() not found\n");
    abort();
  }
  // the host ends a failed rank with MPI_Abort, which discards buffered output, so output is only
  // line-buffered
  setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  raceway_register(this);
  next(this);
}
