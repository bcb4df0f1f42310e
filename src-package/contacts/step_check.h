// SPDX-License-Identifier: GPL-2.0-or-later
// Largest stable step of velocity Verlet, from stiffness and damping in the contact table.
#ifndef BEARING_STEP_CHECK_H
#define BEARING_STEP_CHECK_H

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
  tag_t ball = 0;                           // ball whose contacts set the limit
  double stiffness = 0.0, damping = 0.0;    // N/m and N s/m, summed over that ball's contacts

  std::string why() const;
};

// Minimum over all ranks. Normal direction: sum over the raceways of a ball, with the ball's mass
// m_b; tangential direction: with the mass 2/7 m_b of a rolling sphere; cage contacts: with the
// reduced mass. If no contact is live, the limit is that of the spring at an overlap of 1 um.
StepLimit step_limit(LAMMPS_NS::LAMMPS *lmp, const ContactTable &table);

}    // namespace bearing

#endif
