// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_verlet.h"

#include "../core/settings/arguments.h"
#include "fixes.h"
#include "own_group.h"
#include "pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using bearing::Arguments;

// fix ID group bearing/verlet [tolerance T] ... Keywords for the tolerances of the implicit step
// are ignored, so that the same line of a deck can be used with either integrator.
FixBearingVerlet::FixBearingVerlet(LAMMPS *lmp, int narg, char **arg) : Fix(lmp, narg, arg)
{
  Arguments args(lmp, bearing::name_of(*this), narg, arg, 3);
  std::map<std::string, std::string> ignored;
  while (args.more())
    if (!args.variable_of("bearing/verlet", ignored)) args.unknown();
}

void FixBearingVerlet::BRG_AFTER_CREATION()
{
  const PairBearingHertz &pair = *PairBearingHertz::find(lmp, bearing::name_of(*this));
  const auto is_body = [&](int i) {
    const int type = atom->type[i];
    return (atom->mask[i] & groupbit) && pair.coefficients().is_named(type) &&
           !pair.coefficients().is_ring(type);
  };
  bearing::own_group(lmp, name(), is_body);
  input->one(("fix " + name() + " " + name() + " nve/sphere").c_str());
}

FixBearingVerlet::~FixBearingVerlet()
{
  // Modify may already have been deleted when the host shuts down
  if (modify && modify->nfix && modify->find_fix(name().c_str()) >= 0)
    modify->delete_fix(name().c_str());
}

void FixBearingVerlet::init()
{
  if (modify->find_fix(name().c_str()) < 0)
    BRG_ALL(bearing::name_of(*this) + ": its fix " + name() + " nve/sphere is gone");
}
