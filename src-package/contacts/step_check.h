// SPDX-License-Identifier: GPL-2.0-or-later
// Largest stable step of velocity Verlet, from the stiffness and damping in the contact table.
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
  double stiffness = 0.0, damping = 0.0;    // N/m and N s/m, sums over the contacts of that ball

  std::string why() const;
};

// Minimum over all ranks. Normal: sum over the raceways of a ball, mass m_b; tangential: 2/7 m_b
// (rolling sphere); cage contacts: reduced mass. Without a live contact: the spring at 1 um
// overlap.
StepLimit step_limit(LAMMPS_NS::LAMMPS *lmp, const ContactTable &table);

}    // namespace bearing

#endif
