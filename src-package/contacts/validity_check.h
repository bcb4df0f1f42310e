// SPDX-License-Identifier: GPL-2.0-or-later
// Collects contacts outside the validity range of the models (core/raceway/validity.h) during a
// run. Each kind of violation is reported once.
#pragma once

#include "../core/electric/film_capacitor.h"
#include "../core/figures/contact_table.h"
#include "../core/raceway/validity.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

class ValidityCheck {
 public:
  // Set the shoulders of the grooves in which the balls of a group run, if they are specified in
  // the deck.
  void forget_shoulders() { shoulders_.clear(); }
  void add_shoulders(int groupbit, const raceway::CapacitorModel &m)
  {
    if (m.inner_shoulder > 0.0 || m.outer_shoulder > 0.0) shoulders_.push_back({groupbit, m});
  }
  // Checks the contacts of this rank in this step. `mask` contains the groups of each atom.
  void look(const ContactTable &, const int *mask, bool film);
  // Prints a warning, once per kind, about violations found since the last call. Must be called on
  // all ranks.
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
