// SPDX-License-Identifier: GPL-2.0-or-later
// The only file that knows which host it is compiled for: LIGGGHTS 3.x or LAMMPS (2021, 2022 and later).
// Everything the styles need that differs between the hosts is named BRG_... here, once.
#ifndef BEARING_COMPAT_H
#define BEARING_COMPAT_H

#define BEARING_LIGGGHTS 1      // LIGGGHTS 3.x, the API of LAMMPS of about 2014
#define BEARING_LAMMPS_2021 2   // LAMMPS 29Sep2021
#define BEARING_LAMMPS_2022 3   // LAMMPS 4May2022 and later
#ifndef BEARING_HOST
#  if __has_include("contact_interface.h")
#    define BEARING_HOST BEARING_LIGGGHTS
#  elif __has_include("platform.h")
#    define BEARING_HOST BEARING_LAMMPS_2022
#  else
#    define BEARING_HOST BEARING_LAMMPS_2021
#  endif
#endif
#define BEARING_IS_LIGGGHTS (BEARING_HOST == BEARING_LIGGGHTS)

#include <mpi.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "lmptype.h"
#include "pointers.h"
#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "compute.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "group.h"
#include "input.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "universe.h"
#include "update.h"
#include "variable.h"
#if BEARING_IS_LIGGGHTS
#include "signal_handling.h"
#else
#include "command.h"
#include "timer.h"
#include "utils.h"
#endif

#ifndef NEIGHMASK
#error "lmptype.h without NEIGHMASK: this is neither LIGGGHTS 3.x nor LAMMPS"
#endif

namespace bearing {
#if BEARING_IS_LIGGGHTS
typedef int tag_t;
typedef LAMMPS_NS::Pointers CommandBase;
#else
typedef LAMMPS_NS::tagint tag_t;
typedef LAMMPS_NS::Command CommandBase;
#endif

// Ends the run after the step that is being made, with its output. All ranks must call it in the same step.
inline void end_run_after_this_step(LAMMPS_NS::LAMMPS *lmp)
{
#if BEARING_IS_LIGGGHTS
  (void) lmp;
  LAMMPS_NS::SignalHandler::request_write_restart = false;
  LAMMPS_NS::SignalHandler::request_quit = true;
#else
  lmp->timer->force_timeout();
#endif
}
}    // namespace bearing

#ifndef FLERR
#define FLERR __FILE__, __LINE__
#endif

// Errors and warnings take a std::string: a literal would pick a fmt template in LAMMPS.
#if BEARING_IS_LIGGGHTS
#define BRG_ALL(msg) error->all(FLERR, std::string(msg).c_str())
#define BRG_ONE(msg) error->one(FLERR, std::string(msg).c_str())
#define BRG_WARN(msg) error->warning(FLERR, std::string(msg).c_str())
#define BRG_BOUNDS(s, n, lo, hi) force->bounds(s, n, lo, hi)
#define BRG_EV_INIT(e, v) do { if (e || v) ev_setup(e, v); else evflag = vflag_fdotr = 0; } while (0)
#define BRG_PACK_FORWARD pack_comm
#define BRG_UNPACK_FORWARD unpack_comm
#define BRG_READ_RESTART_SIG (FILE *fp, const int major, const int minor)
#define BRG_UNUSED_RESTART_ARGS do { (void) major; (void) minor; } while (0)
// values per atom; LAMMPS wants the total
#define BRG_COMM_RETURN(total, peratom) ((void) (total), (peratom))
// LIGGGHTS calls set_arrays() for all atoms in the first setup, after forces and restart data are there
#define BRG_ARRAYS_ARE_SET() just_created = 0
#define BRG_FORWARD_FIX(fix) comm->forward_comm_fix(fix)
#define BRG_SET_MAXEXCHANGE(n) \
  comm->maxexchange_fix = comm->maxexchange_fix > (int) (n) ? comm->maxexchange_fix : (int) (n)
#define BRG_REQUEST_HALF() neighbor->request(this)
#define BRG_COMPUTE_ARGS LAMMPS *lmp, int &iarg, int narg, char **arg
#define BRG_COMPUTE_BASE Compute(lmp, iarg, narg, arg)
#define BRG_COMPUTE_FIRST iarg
#define BRG_VARIABLE(name) input->variable->find(const_cast<char *>(name))
#else
#define BRG_ALL(msg) error->all(FLERR, std::string(msg))
#define BRG_ONE(msg) error->one(FLERR, std::string(msg))
#define BRG_WARN(msg) error->warning(FLERR, std::string(msg))
#define BRG_BOUNDS(s, n, lo, hi) LAMMPS_NS::utils::bounds(FLERR, s, 1, n, lo, hi, error)
#define BRG_EV_INIT(e, v) ev_init(e, v)
#define BRG_PACK_FORWARD pack_forward_comm
#define BRG_UNPACK_FORWARD unpack_forward_comm
#define BRG_READ_RESTART_SIG (FILE *fp)
#define BRG_UNUSED_RESTART_ARGS do { } while (0)
#define BRG_COMM_RETURN(total, peratom) ((void) (peratom), (total))
#define BRG_ARRAYS_ARE_SET() do { } while (0)
#if BEARING_HOST == BEARING_LAMMPS_2022
#define BRG_FORWARD_FIX(fix) comm->forward_comm(fix)
#define BRG_REQUEST_HALF() neighbor->add_request(this)
#else
#define BRG_FORWARD_FIX(fix) comm->forward_comm_fix(fix)
#define BRG_REQUEST_HALF() neighbor->request(this, instance_me)
#endif
#define BRG_SET_MAXEXCHANGE(n) maxexchange = (n)
#define BRG_COMPUTE_ARGS LAMMPS *lmp, int narg, char **arg
#define BRG_COMPUTE_BASE Compute(lmp, narg, arg)
#define BRG_COMPUTE_FIRST 3
#define BRG_VARIABLE(name) input->variable->find(name)
#endif

#endif
