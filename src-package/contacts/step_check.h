// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the largest stable step of velocity Verlet from the stiffness and damping in the contact
// table.
#pragma once

#include "../core/figures/contact_table.h"

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

struct StepLimit {
  enum Cause { unloaded, spring, film_damper, tangential, cage };
  double step = HUGE_VAL;    // s
  int cause = unloaded;
  tag_t ball = 0;                           // ball whose contacts determine the limit
  double stiffness = 0.0, damping = 0.0;    // N/m and N s/m, summed over the contacts of that ball

  std::string why() const;
};

// Returns the minimum over all ranks. In the normal direction, the limit follows from the sum over
// the raceways of a ball and from the ball's mass m_b. In the tangential direction, it follows from
// the effective mass 2/7 m_b of a rolling sphere, and at cage contacts from the reduced mass. If no
// contact is live, the limit is that of the spring at an overlap of 1 um.
StepLimit step_limit(LAMMPS_NS::LAMMPS *lmp, const ContactTable &table);

}    // namespace bearing
