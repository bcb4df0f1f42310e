// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts in doubt (core/raceway/validity.h), gathered over a run and said once.
#ifndef BEARING_VALIDITY_CHECK_H
#define BEARING_VALIDITY_CHECK_H

#include "../core/electric/film_capacitor.h"
#include "../core/figures/contact_table.h"
#include "../core/raceway/validity.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

class ValidityCheck {
 public:
  // Shoulders of the grooves that balls of a group run in, where a deck says them
  void forget_shoulders() { shoulders_.clear(); }
  void add_shoulders(int groupbit, const raceway::CapacitorModel &m)
  {
    if (m.inner_shoulder > 0.0 || m.outer_shoulder > 0.0) shoulders_.push_back({groupbit, m});
  }
  // At the contacts of this step and rank; `mask` says the groups of atoms.
  void look(const ContactTable &, const int *mask, bool film);
  // Warns of what was found since the last call, once for each doubt. All ranks call it.
  void report(LAMMPS_NS::LAMMPS *, bool capacitance);

 private:
  struct OfGroup {
    int groupbit;
    raceway::CapacitorModel model;
  };
  void look_at_shoulders(const RacewayContact &, int mask);
  raceway::Validity found_;
  std::vector<OfGroup> shoulders_;
  bool said_[raceway::Validity::N] = {};
};

}    // namespace bearing

#endif
