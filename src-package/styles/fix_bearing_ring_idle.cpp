// SPDX-License-Identifier: GPL-2.0-or-later
// The part of fix bearing/ring that warns of loads without effect, for example because they were
// meant for bearings with another axis.
#include "../core/settings/arguments.h"
#include "fix_bearing_ring.h"
#include "fixes.h"

using namespace LAMMPS_NS;
using bearing::text;

// Warns, once, of a force (N) or moment (N m) along a degree of freedom that is not free. Values
// below 1e-6 are rounding errors of a formula or an azimuth.
void FixBearingRing::warn_if_idle(int dof, double load, const char *force)
{
  if (settings_.program.free(dof) || std::fabs(load) < 1e-6) return;
  const bool turns = dof >= RingProgram::TILT;
  const std::string axis(1, static_cast<char>('x' + axes_.lab_axis(dof % 3)));
  const std::string what = turns ? "moment" : force;
  if (!idle_.insert(what + axis).second || comm->me != 0) return;
  BRG_WARN(bearing::name_of(*this) + ": " + what + " of " + text(load) +
           (turns ? " N m about " : " N along ") + axis + " has no effect, because " +
           (dof == RingProgram::SPIN ? "spin"
            : turns                  ? "r" + axis
                                     : axis) +
           " is not free");
}

// Warns at the start of a run of loads that are not values at an instant: those of single rings,
// and those that rotate.
void FixBearingRing::warn_of_idle_loads()
{
  for (int k : own_) {
    if (k < RingProgram::FORCE) continue;
    double load[2] = {0.0, 0.0};    // the largest and the negative of the smallest
    for (int i = 0; i < atom->nlocal; ++i)
      if (moves(i))
        for (int sign = 0; sign < 2; ++sign)
          load[sign] = std::fmax(load[sign], (sign ? -1.0 : 1.0) * per_ring_[i].of[k]);
    MPI_Allreduce(MPI_IN_PLACE, load, 2, MPI_DOUBLE, MPI_MAX, world);
    warn_if_idle(k - RingProgram::FORCE, load[0] >= load[1] ? load[0] : -load[1]);
  }
  const RingProgram &p = settings_.program;
  if (p.free(0) || p.free(1)) return;
  for (const auto &[what, size, unit] : {std::tuple{"rotating force", p.turning.size, "N"},
                                         std::tuple{"unbalance", p.unbalance.moment, "kg m"}})
    if (size != 0.0 && idle_.insert(what).second && comm->me == 0)
      BRG_WARN(bearing::name_of(*this) + ": " + what + " of " + text(size) + " " + unit +
               " has no effect, because neither " + "xyz"[axes_.lab_axis(0)] + " nor " +
               "xyz"[axes_.lab_axis(1)] + " is free");
}
