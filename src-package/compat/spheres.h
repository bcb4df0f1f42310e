// SPDX-License-Identifier: GPL-2.0-or-later
// Keywords for spheres that differ between LIGGGHTS and LAMMPS.
#ifndef BEARING_SPHERES_H
#define BEARING_SPHERES_H

#include "bearing_compat.h"

namespace bearing {

inline bool is_liggghts() { return std::string(BRG_HOST_KIND) == "liggghts"; }

inline const char *sphere_style() { return is_liggghts() ? "granular" : "sphere"; }
// Returns the command with which velocities are also sent to ghost atoms.
inline const char *ghost_velocities()
{
  return is_liggghts() ? "communicate single vel yes" : "comm_modify mode single vel yes";
}
// Returns the keyword of dump_modify that precedes the format of a line.
inline const char *line_format() { return is_liggghts() ? "format" : "format line"; }

}    // namespace bearing

#endif
