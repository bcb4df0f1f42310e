// SPDX-License-Identifier: GPL-2.0-or-later
// The largest step that velocity Verlet stands, from the stiffness and damping in the contact
// table.
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
  tag_t ball = 0;                           // whose contacts set it
  double stiffness = 0.0, damping = 0.0;    // N/m and N s/m of that ball, all contacts together

  std::string why() const;
};

// Over all ranks. Normal: sum over the raceways of a ball, mass m_b; tangential: 2/7 m_b (rolling
// sphere); cage contacts: reduced mass. With no contact at all, the spring at 1 um overlap.
StepLimit step_limit(LAMMPS_NS::LAMMPS *lmp, const ContactTable &table);

}    // namespace bearing

#endif
