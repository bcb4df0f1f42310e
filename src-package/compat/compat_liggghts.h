// SPDX-License-Identifier: GPL-2.0-or-later
// Interface of LIGGGHTS 3.x, which corresponds to a LAMMPS version from about 2014.
#pragma once

#include "../core/numbers/tag.h"
#include "signal_handling.h"

namespace bearing {
typedef LAMMPS_NS::Pointers CommandBase;

// Ends the run after the current step, whose output is still written. All ranks must call it in the
// same step.
inline void end_run_after_this_step(LAMMPS_NS::LAMMPS *)
{
  LAMMPS_NS::SignalHandler::request_write_restart = false;
  LAMMPS_NS::SignalHandler::request_quit = true;
}
}    // namespace bearing

#define BRG_HOST_NAME std::string("LIGGGHTS 3.8.0")
#define BRG_GHOST_COMMAND "communicate single"
#define BRG_LINE_FORMAT "format"    // keyword of dump_modify that precedes the format of a line
#define BRG_TEXT(msg) std::string(msg).c_str()
#define BRG_EV_INIT(e, v)          \
  do {                             \
    if (e || v) ev_setup(e, v);    \
    else evflag = vflag_fdotr = 0; \
  } while (0)
#define BRG_PACK_FORWARD pack_comm
#define BRG_UNPACK_FORWARD unpack_comm
#define BRG_READ_RESTART_SIG (FILE * fp, const int major, const int minor)
#define BRG_READ_RESTART_ARGS (fp, major, minor)
#define BRG_UNUSED_RESTART_ARGS \
  do {                          \
    (void)major;                \
    (void)minor;                \
  } while (0)
// returns the number of values per atom; LAMMPS expects the total
#define BRG_COMM_RETURN(total, peratom) ((void)(total), (peratom))
// LIGGGHTS calls set_arrays() for all atoms in the first set-up, when forces and restart data have
// already been set
#define BRG_ARRAYS_ARE_SET() just_created = 0
#define BRG_CHANGES_BOX(fix) ((fix).box_change_size || (fix).box_change_shape)
#define BRG_FORWARD_FIX(fix) comm->forward_comm_fix(fix)
#define BRG_AFTER_CREATION post_create
#define BRG_SET_MAXEXCHANGE(n) \
  comm->maxexchange_fix = comm->maxexchange_fix > (int)(n) ? comm->maxexchange_fix : (int)(n)
#define BRG_REQUEST_HALF() neighbor->request(this)
#define BRG_COMPUTE_ARGS LAMMPS *lmp, int &iarg, int narg, char **arg
#define BRG_COMPUTE_BASE Compute(lmp, iarg, narg, arg)
#define BRG_COMPUTE_FIRST iarg
