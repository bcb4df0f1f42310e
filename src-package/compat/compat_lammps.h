// SPDX-License-Identifier: GPL-2.0-or-later
// Interface of LAMMPS 29Sep2021 and later.
#pragma once

#include "../core/numbers/tag.h"
#include "command.h"
#include "timer.h"

namespace bearing {
static_assert(sizeof(tag_t) == sizeof(LAMMPS_NS::tagint),
              "LAMMPS_BIGBIG must be defined as in the host");
typedef LAMMPS_NS::Command CommandBase;

// Ends the run after the current step, whose output is still written. All ranks must call it in the
// same step.
inline void end_run_after_this_step(LAMMPS_NS::LAMMPS *lmp) { lmp->timer->force_timeout(); }
}    // namespace bearing

#define BRG_HOST_NAME (std::string("LAMMPS ") + lmp->version)
#define BRG_GHOST_COMMAND "comm_modify"
#define BRG_LINE_FORMAT "format line"
#define BRG_TEXT(msg) std::string(msg)    // a literal would select a template of fmt
#define BRG_EV_INIT(e, v) ev_init(e, v)
#define BRG_PACK_FORWARD pack_forward_comm
#define BRG_UNPACK_FORWARD unpack_forward_comm
#define BRG_READ_RESTART_SIG (FILE * fp)
#define BRG_READ_RESTART_ARGS (fp)
#define BRG_UNUSED_RESTART_ARGS \
  do {                          \
  } while (0)
// returns the total; LIGGGHTS expects the number of values per atom
#define BRG_COMM_RETURN(total, peratom) ((void)(peratom), (total))
#define BRG_ARRAYS_ARE_SET() \
  do {                       \
  } while (0)
#define BRG_AFTER_CREATION post_constructor
#define BRG_CHANGES_BOX(fix) (((fix).box_change & ~BOX_CHANGE_DOMAIN) != 0)
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
