// SPDX-License-Identifier: GPL-2.0-or-later
// Exports estimated data of a one-piece cage, and the couples that the oil exerts on the cage
// (cage_drag.h).
#include "../geometry/cage_ring.h"
#include "exports.h"

using namespace raceway;

FORMULA(double, usual_play, ()) { return raceway::usual_play; }

// `play` is measured along the pitch circle, in m.
FORMULA(double, pocket_shear, (double viscosity, double ball_radius, double play, double filled))
{
  return raceway::pocket_shear(viscosity, ball_radius, usual_band * 2.0 * ball_radius, 0.5 * play,
                               filled);
}

// `width` is the total width of both lands, in m. The cage is off centre by `share` of the
// clearance.
FORMULA(double, land_couple,
        (double viscosity, double radius, double clearance, double width, double filled,
         double share))
{
  return raceway::land_couple({radius, clearance, width, 1, viscosity, filled}, share);
}

FORMULA(double, cage_churning,
        (double share, double density, double viscosity, double pitch, double ball_radius,
         double speed))
{
  return churning_couple(share, density, viscosity, pitch + usual_reach * 2.0 * ball_radius, speed);
}
