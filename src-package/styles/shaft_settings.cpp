// SPDX-License-Identifier: GPL-2.0-or-later
#include "shaft_settings.h"

using raceway::RingProgram;

namespace bearing {

bool ShaftSettings::take(Arguments &args)
{
  if (args.take("centre")) {
    centre = args.number("centre of mass along the axis (m)");
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
    return false;
  }
  return true;
}

// The sum of forces that turn together is one that turns so, too.
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

}    // namespace bearing
