// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts in doubt (physics/validity.h), gathered over a run and said once.
#ifndef BEARING_VALIDITY_CHECK_H
#define BEARING_VALIDITY_CHECK_H

#include "../physics/validity.h"
#include "contact_table.h"

namespace bearing {

class ValidityCheck {
 public:
  void look(const ContactTable &, bool film);    // at the contacts of this step and rank
  // Warns of what was found since the last call, once for each doubt. All ranks call it.
  void report(LAMMPS_NS::LAMMPS *, bool capacitance);

 private:
  raceway::Validity found_;
  bool said_[raceway::Validity::N] = {};
};

}    // namespace bearing

#endif
