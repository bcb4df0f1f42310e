// SPDX-License-Identifier: GPL-2.0-or-later
// The loss columns of all parts of the contact law (loss.h), and the losses of a contact in these
// columns.
#pragma once

#include "../parts/loss.h"
#include "../parts/part.h"

#include <vector>

namespace raceway {

// Maximum number of loss columns; loss_table.cpp asserts that it is sufficient.
constexpr int most_loss_columns = 8;

// Power dissipated in each loss column, W.
struct LossPowers {
  double of[most_loss_columns] = {};
};

// Returns the losses of a loaded contact; they are 0 for parts that are not in its law.
LossPowers loss_powers(const ContactState &c);

struct LossEntry {
  LossColumn is;
  unsigned parts;                                            // set of the parts that have this loss
  double (*value)(const Raceway &, const ContactState &);    // power (W) that a contact dissipates
  StateColumn column() const
  {
    return {{is.name, "W", is.meaning, vanishes}, value, Needs::nothing, is.usual};
  }
};

// Returns the loss columns in the order used by every output.
const std::vector<LossEntry> &loss_table();

}    // namespace raceway
