// SPDX-License-Identifier: GPL-2.0-or-later
// The losses of a contact. A loss is a struct with an output column and a power; each part of the
// contact law lists its losses, for example
//
//   struct SpinLoss {
//     static constexpr LossColumn column = {"spin_power", "spin", "power dissipated by spin",
//                                           false};
//     template <class T> static Value<T> of(const ContactStateT<T> &c);    // W
//   };
//   using Losses = LossList<SpinLoss>;
//
// Parts that exclude each other share a loss; losses of different parts may share a column. The
// total loss of a law, the columns for contacts, rings, bearings and records, and losses_W in
// `raceway summary` all follow from these lists (loss_table.h).
#pragma once

#include "../raceway/contact_state.h"

namespace raceway {

struct LossColumn {
  const char *name;    // name of the column, in W
  const char *key;     // key in losses_W in `raceway summary`
  const char *meaning;
  bool usual;    // true: a column of every law, included in records by default
};

template <class... L> struct LossList {
  // Returns the sum of the powers of the losses, W.
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &c)
  {
    Value<T> sum = Value<T>();
    ((sum += L::of(c)), ...);
    return sum;
  }
};
template <> struct LossList<> {
  template <class T> static RACEWAY_INLINE Value<T> of(const ContactStateT<T> &)
  {
    return Value<T>();
  }
};

}    // namespace raceway
