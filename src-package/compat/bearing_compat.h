// SPDX-License-Identifier: GPL-2.0-or-later
// Includes the host's headers and defines common names (BRG_...) for everything that differs
// between hosts. The include path determines the host: LIGGGHTS 3.x, LAMMPS 29Sep2021 (Debian 12),
// or LAMMPS 4May2022 and later.
#pragma once

#define BEARING_LIGGGHTS 1
#define BEARING_LAMMPS_2021 2
#define BEARING_LAMMPS_2022 3
#ifndef BEARING_HOST
#if __has_include("contact_interface.h")
#define BEARING_HOST BEARING_LIGGGHTS
#elif __has_include("platform.h")
#define BEARING_HOST BEARING_LAMMPS_2022
#else
#define BEARING_HOST BEARING_LAMMPS_2021
#endif
#endif
#define BEARING_IS_LIGGGHTS (BEARING_HOST == BEARING_LIGGGHTS)

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mpi.h>
#include <string>

#include "atom.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "lmptype.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "pointers.h"
#include "universe.h"
#include "update.h"
#include "variable.h"

#ifndef NEIGHMASK
#error "lmptype.h without NEIGHMASK: this is neither LIGGGHTS 3.x nor LAMMPS"
#endif

#ifndef FLERR
#define FLERR __FILE__, __LINE__
#endif

#if BEARING_IS_LIGGGHTS
#include "compat_liggghts.h"
#else
#include "compat_lammps.h"
#endif

// Raise errors on all ranks or on one rank, and print warnings, through the functions of the host.
// The message is a std::string.
#define BRG_ALL(msg) error->all(FLERR, BRG_TEXT(msg))
#define BRG_ALL_OF(lmp, msg) lmp->error->all(FLERR, BRG_TEXT(msg))
#define BRG_ONE(msg) error->one(FLERR, BRG_TEXT(msg))
#define BRG_WARN(msg) error->warning(FLERR, BRG_TEXT(msg))
