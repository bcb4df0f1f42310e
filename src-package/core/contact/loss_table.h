// SPDX-License-Identifier: GPL-2.0-or-later
// The loss columns of all parts of the contact law (loss.h), and the losses of a contact by column.
#ifndef RACEWAY_LOSS_TABLE_H
#define RACEWAY_LOSS_TABLE_H

#include "../parts/loss.h"
#include "../parts/part.h"

#include <vector>

namespace raceway {

// Room for the losses of a contact; loss_table.cpp asserts that it is enough.
constexpr int most_loss_columns = 16;

// W, by column
struct LossPowers {
  double of[most_loss_columns] = {};
};

// Of a contact that is loaded; a loss of a part that its law leaves out is 0.
LossPowers loss_powers(const ContactState &c);

struct LossEntry {
  LossColumn is;
  unsigned parts;                                            // that have this loss
  double (*value)(const Raceway &, const ContactState &);    // W, of a contact
  StateColumn column() const
  {
    return {{is.name, "W", is.meaning, vanishes}, value, Needs::nothing, is.usual};
  }
};

// The loss columns, in the order of every output.
const std::vector<LossEntry> &loss_table();

}    // namespace raceway

#endif
