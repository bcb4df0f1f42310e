// SPDX-License-Identifier: GPL-2.0-or-later
// The loss columns of all parts of the contact law (loss.h), and the losses of a contact by column.
#ifndef RACEWAY_LOSS_TABLE_H
#define RACEWAY_LOSS_TABLE_H

#include "contact.h"

#include <utility>

namespace raceway {

namespace detail {
// Known with those of the lists that follow, each once.
template <class Known, class... Lists> struct DistinctLosses {
  using type = Known;
};
template <class... Known, class... More>
struct DistinctLosses<LossList<Known...>, LossList<>, More...>
    : DistinctLosses<LossList<Known...>, More...> {};
template <class... Known, class L, class... Rest, class... More>
struct DistinctLosses<LossList<Known...>, LossList<L, Rest...>, More...>
    : std::conditional_t<(std::is_same<Known, L>::value || ...),
                         DistinctLosses<LossList<Known...>, LossList<Rest...>, More...>,
                         DistinctLosses<LossList<Known..., L>, LossList<Rest...>, More...>> {};
template <class All> struct LossesOf;
template <class... P>
struct LossesOf<PartList<P...>> : DistinctLosses<LossList<>, typename P::Losses...> {};

constexpr bool same_text(const char *a, const char *b)
{
  while (*a && *a == *b) ++a, ++b;
  return *a == *b;
}
// The place of a column: outputs keep the order that they had before parts named their losses; the
// others follow as they come. Of a name that no loss has: the number of columns.
template <class... L> constexpr int loss_place(LossList<L...>, const char *name)
{
  const char *const names[] = {"friction_power", "damping_power", L::column.name...};
  constexpr int n = sizeof...(L) + 2;
  int place = 0;
  for (int i = 0; i < n; ++i) {
    if (same_text(names[i], name)) return place;
    bool known = false;
    for (int k = 0; k < i; ++k) known = known || same_text(names[k], names[i]);
    if (!known) ++place;
  }
  return place;
}
}    // namespace detail

using AllLosses = detail::LossesOf<Parts>::type;    // each once
constexpr int loss_columns = detail::loss_place(AllLosses(), "");

// W, by column
struct LossPowers {
  double of[loss_columns] = {};
};

namespace detail {
template <class... L> inline LossPowers loss_powers(LossList<L...>, const ContactState &c)
{
  LossPowers powers;
  ((powers.of[std::integral_constant<int, loss_place(AllLosses(), L::column.name)>::value] +=
    L::of(c)),
   ...);
  return powers;
}
template <class... L> inline LossColumn loss_column(LossList<L...>, int place)
{
  LossColumn found = {};
  (void)((loss_place(AllLosses(), L::column.name) == place && (found = L::column, true)) || ...);
  return found;
}
template <class... L> constexpr bool has_loss(LossList<L...>, [[maybe_unused]] int place)
{
  return ((loss_place(AllLosses(), L::column.name) == place) || ...);
}
template <int place> double loss_value(const Raceway &, const ContactState &c)
{
  return loss_powers(AllLosses(), c).of[place];
}
}    // namespace detail

// Of a contact that is loaded; a loss of a part that its law leaves out is 0.
inline LossPowers loss_powers(const ContactState &c) { return detail::loss_powers(AllLosses(), c); }

struct LossEntry {
  LossColumn is;
  unsigned parts;                                            // that have this loss
  double (*value)(const Raceway &, const ContactState &);    // W, of a contact
  StateColumn column() const
  {
    return {{is.name, "W", is.meaning, vanishes}, value, Needs::nothing, is.usual};
  }
};

namespace detail {
template <int... place> std::vector<LossEntry> loss_entries(std::integer_sequence<int, place...>)
{
  std::vector<LossEntry> table = {{loss_column(AllLosses(), place), 0u, &loss_value<place>}...};
  Parts::each([&table](auto tag) {
    using Part = typename decltype(tag)::type;
    for (int k = 0; k < loss_columns; ++k)
      if (has_loss(typename Part::Losses(), k)) table[k].parts |= Parts::bit<Part>();
  });
  return table;
}
}    // namespace detail

// The loss columns, in the order of every output.
inline const std::vector<LossEntry> &loss_table()
{
  static const std::vector<LossEntry> table =
      detail::loss_entries(std::make_integer_sequence<int, loss_columns>());
  return table;
}

}    // namespace raceway

#endif
