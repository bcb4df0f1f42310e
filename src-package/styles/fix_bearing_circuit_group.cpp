// SPDX-License-Identifier: GPL-2.0-or-later
#include "../ranks/gather.h"
#include "fix_bearing_circuit.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::tag_t;

// Stops with an error if a ring has balls inside and outside the group: the current also flows
// through the latter.
void FixBearingCircuit::check_group() const
{
  std::vector<tag_t> inside, outside;    // rings of these balls
  for (const bearing::RacewayContact &c : pair_->table().raceway)
    (atom->mask[c.i_ball] & groupbit ? inside : outside).push_back(c.ring);
  inside = bearing::gather_all(inside, world);
  std::sort(inside.begin(), inside.end());
  for (const tag_t ring : bearing::gather_all(outside, world))
    if (std::binary_search(inside.begin(), inside.end(), ring))
      BRG_ALL(bearing::name_of(*this) + ": group " + group->names[igroup] +
              " has only some of the balls of ring atom " + std::to_string(ring));
}
