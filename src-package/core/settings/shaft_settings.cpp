// SPDX-License-Identifier: GPL-2.0-or-later
#include "shaft_settings.h"

#include <cmath>

using raceway::RingProgram;

namespace bearing {

bool ShaftSettings::take(Arguments &args)
{
  if (args.number("centre", centre, "centre of mass along the axis (m)")) {
    centre_given = true;
  } else if (args.take("load")) {
    Load load;
    load.at = args.number("place of the load along the axis (m)");
    for (DrivenValue &f : load.force) f = DrivenValue::read(args, "load (N)");
    loads.push_back(load);
  } else if (args.take("unbalance")) {
    Unbalance u;
    u.at = args.number("place of the unbalance along the axis (m)");
    u.of.moment = args.non_negative("unbalance (kg m)");
    u.of.phase = args.number("phase of the unbalance (rad)");
    unbalances.push_back(u);
  } else {
    return args.word("flexible", file, "file of a flexible shaft");
  }
  return true;
}

// Returns the unbalance that has these components. Unbalances are added component by component,
// because they rotate together.
static raceway::Unbalance polar(double x, double y) { return {std::hypot(x, y), std::atan2(y, x)}; }

void ShaftSettings::add_unbalances(double about, RingProgram &p) const
{
  double sum[2] = {}, first[2] = {};
  for (const Unbalance &u : unbalances) {
    const double part[] = {u.of.moment * std::cos(u.of.phase), u.of.moment * std::sin(u.of.phase)};
    for (int k = 0; k < 2; ++k) {
      sum[k] += part[k];
      first[k] += (u.at - about) * part[k];
    }
  }
  p.unbalance = polar(sum[0], sum[1]);
  p.couple = polar(first[0], first[1]);
  p.apart = !loads.empty() || p.couple.moment > 0.0;
}

std::vector<raceway::Unbalance> ShaftSettings::unbalances_of_modes() const
{
  const raceway::ShaftModes &modes = of_file->modes;
  std::vector<raceway::Unbalance> of;
  for (int k = 0; k < modes.size(); ++k) {
    double sum[2] = {};
    for (const Unbalance &u : unbalances) {
      const double size = u.of.moment * modes.station(u.at - of_file->centre).moved[k];
      sum[0] += size * std::cos(u.of.phase);
      sum[1] += size * std::sin(u.of.phase);
    }
    of.push_back(polar(sum[0], sum[1]));
  }
  return of;
}

void ShaftSettings::read_file(const Arguments &args, RingProgram &p)
{
  if (p.mass > 0.0 || p.inertia.axial > 0.0 || centre_given)
    args.fail("mass, inertia and centre of a flexible shaft come from '" + file +
              "': leave them out");
  for (int dof : {0, 1, int(RingProgram::TILT), int(RingProgram::TILT + 1)})
    if (!p.free(dof))
      args.fail("a flexible shaft needs both transverse displacements and both tilts 'free'");
  of_file = std::make_shared<BendingShaft>(read_bending_shaft(args, file));
  p.mass = of_file->mass;
  p.inertia = of_file->inertia;
  centre = of_file->centre;
  centre_given = true;
}

}    // namespace bearing
