// SPDX-License-Identifier: GPL-2.0-or-later
#include "shaft_bend.h"

#include "../numbers/cubic.h"

namespace raceway {

const std::vector<double> &ShaftBend::loads(const RingProgram &p, const RingPose &rigid, double s)
{
  program.forces(p, s, rigid.angle, loads_);
  return loads_;
}

const std::vector<double> &ShaftBend::forces(const RingProgram &p, const RingPose &rigid, double s)
{
  own_forces(*modes, now, rigid, forces_);
  loads(p, rigid, s);
  for (int k = 0; k < size(); ++k) forces_[k] += contacts[k] + loads_[k];
  if (p.supported) add_supports(*centre, p, bent_centre(rigid), forces_);
  return forces_;
}

void ShaftBend::move(double h, double)
{
  for (int k = 0; k < size(); ++k) {
    now.rate[k] = base.rate[k] + gained[k];
    now.place[k] = base.place[k] + h * now.rate[k];
  }
}

void ShaftBend::second_base(double beyond)
{
  first = now;
  for (int k = 0; k < size(); ++k) {
    base.place[k] = from.place[k] + beyond * (now.place[k] - from.place[k]);
    base.rate[k] = from.rate[k] + beyond * (now.rate[k] - from.rate[k]);
  }
}

void ShaftBend::between(double h, double s)
{
  const Cubic at(s, h);
  for (int k = 0; k < size(); ++k) {
    now.place[k] = at(from.place[k], from.rate[k], end.place[k], end.rate[k]);
    now.rate[k] = from.rate[k] + (end.rate[k] - from.rate[k]) * s;
  }
}

}    // namespace raceway
