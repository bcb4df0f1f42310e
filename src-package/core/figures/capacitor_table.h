// SPDX-License-Identifier: GPL-2.0-or-later
// Capacitors formed by the contacts in the contact table, including their surroundings. They are
// computed once each time the table has been filled, for four contacts of a raceway at a time.
#pragma once

#include "../electric/film_capacitor.h"
#include "contact_table.h"

#include <functional>

namespace bearing {

class CapacitorTable {
 public:
  // Selects the contacts. Must be called whenever the indices of the table have changed.
  void plan(const ContactTable &, const raceway::CapacitorModel &,
            const std::function<bool(const RacewayContact &)> &counts);
  // Must be called after the table has been filled.
  void fill(const ContactTable &);
  // Returns the capacitor of a row of the table, which is 0 for a contact that is not selected.
  const raceway::FilmCapacitorT<double> &operator[](size_t row) const { return of_[row]; }

 private:
  struct Batch {
    raceway::SurroundedRaceway raceway;
    std::vector<int> rows;
  };
  void fill(const ContactTable &, const Batch &);

  std::vector<Batch> batches_;
  std::vector<raceway::FilmCapacitorT<double>> of_;
};

}    // namespace bearing
