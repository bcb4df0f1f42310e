// SPDX-License-Identifier: GPL-2.0-or-later
#include "named_bearing.h"

#include "../core/settings/written.h"
#include "bearing_compat.h"

namespace bearing {

// A new instance of the host may have the same address as an earlier one, but it does not have the
// variables of that instance. The variables set by the command `bearing` show whether a name
// belongs to this instance.
static std::map<std::pair<const LAMMPS_NS::LAMMPS *, std::string>, NamedBearing> &kept()
{
  static std::map<std::pair<const LAMMPS_NS::LAMMPS *, std::string>, NamedBearing> bearings;
  return bearings;
}

static bool is_alive(const LAMMPS_NS::LAMMPS *lmp, const std::string &name)
{
  return lmp->input->variable->find(const_cast<char *>((name + "_balls").c_str())) >= 0;
}

void keep_bearing(const LAMMPS_NS::LAMMPS *lmp, const NamedBearing &bearing)
{
  if (lmp->domain->box_exist == 0)    // after `clear`, another deck begins
    for (auto at = kept().begin(); at != kept().end();)
      at = at->first.first == lmp && at->second.in_use ? kept().erase(at) : std::next(at);
  kept()[{lmp, bearing.name}] = bearing;
}

const NamedBearing *find_bearing(const LAMMPS_NS::LAMMPS *lmp, const std::string &name)
{
  const auto at = kept().find({lmp, name});
  return at == kept().end() || !is_alive(lmp, name) ? nullptr : &at->second;
}

std::vector<const NamedBearing *> bearings_of(const LAMMPS_NS::LAMMPS *lmp)
{
  std::vector<const NamedBearing *> list;
  for (const auto &one : kept())
    if (one.first.first == lmp && is_alive(lmp, one.first.second)) list.push_back(&one.second);
  return list;
}

const NamedBearing *bearing_of_type(const LAMMPS_NS::LAMMPS *lmp, int type)
{
  for (const NamedBearing *one : bearings_of(lmp))
    if (one->balls == type || one->inner == type) return one;
  return nullptr;
}

const NamedBearing &bearing_of(LAMMPS_NS::LAMMPS *lmp, const Arguments &args,
                               const std::string &name)
{
  if (const NamedBearing *found = find_bearing(lmp, name)) return *found;
  std::vector<std::string> names;
  for (const NamedBearing *one : bearings_of(lmp)) names.push_back(one->name);
  args.fail("there is no bearing '" + name + "'; there is: " +
            (names.empty() ? "none; the command 'bearing' names a bearing" : joined(names)));
}

}    // namespace bearing
