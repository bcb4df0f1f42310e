// SPDX-License-Identifier: GPL-2.0-or-later
// Constants and keyword parameters shared by the parts for slip in rolling contacts.
#pragma once

#include "../laws/differential_slip.h"
#include "part_friction.h"

namespace raceway {

// Parameters of a slip law in series with the contact's tangential spring.
struct SlipParameters {
  double least = 1e-4;                  // m/s, lower limit of s_e; as the motion ceases, the law
                                        // tends to Coulomb's law
  double kt_ratio = 0.0, lift = 0.0;    // computed by prepare(); 1/m, 1/(2 R_d)
  void prepare(const Raceway &p)
  {
    kt_ratio = tangential_ratio(p.material.ball_young, p.material.ball_poisson,
                                p.material.ring_young, p.material.ring_poisson);
    lift = 0.5 / deformed_radius(p.groove.groove_radius, p.groove.ball_radius);
  }
};

template <class Own> Parameter<Own> least_slip_width()
{
  return Parameter<Own>::positive("S_LEAST", "minimum width of the differential slip (m/s)",
                                  [](Raceway &, Own &own) -> double & { return own.least; });
}

template <class Own> Parameter<Own> share_of_spin()
{
  return Parameter<Own>::within("SHARE", "ratio of friction in spin to friction in slip", 0.0, 1.0,
                                [](Raceway &, Own &own) -> double & { return own.share; });
}

}    // namespace raceway
