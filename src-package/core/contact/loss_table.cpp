// SPDX-License-Identifier: GPL-2.0-or-later
#include "loss_table.h"

#include "contact.h"

#include <utility>

namespace raceway {

namespace {
// The losses in Known, followed by those that Lists add; each loss occurs only once.
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
// Returns the position of a column. For compatibility with versions in which parts did not declare
// their losses, outputs keep the column order of those versions; new columns follow in the order of
// the parts. For a name that is not a loss, the result is the number of columns.
template <class... L> constexpr int loss_place(LossList<L...>, const char *name)
{
  const char *const names[] = {"friction_power",   "damping_power", "rolling_power",
                               "hysteresis_power", "spin_power",    L::column.name...};
  constexpr int n = sizeof...(L) + 5;
  int place = 0;
  for (int i = 0; i < n; ++i) {
    if (same_text(names[i], name)) return place;
    bool known = false;
    for (int k = 0; k < i; ++k) known = known || same_text(names[k], names[i]);
    if (!known) ++place;
  }
  return place;
}

using AllLosses = LossesOf<Parts>::type;    // every loss occurs only once
constexpr int loss_columns = loss_place(AllLosses(), "");
static_assert(loss_columns <= most_loss_columns, "loss_table.h: most_loss_columns is too small");

template <class... L> LossPowers loss_powers(LossList<L...>, const ContactState &c)
{
  LossPowers powers;
  ((powers.of[std::integral_constant<int, loss_place(AllLosses(), L::column.name)>::value] +=
    L::of(c)),
   ...);
  return powers;
}
template <class... L> LossColumn loss_column(LossList<L...>, int place)
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
}    // namespace

LossPowers loss_powers(const ContactState &c) { return loss_powers(AllLosses(), c); }

const std::vector<LossEntry> &loss_table()
{
  static const std::vector<LossEntry> table =
      loss_entries(std::make_integer_sequence<int, loss_columns>());
  return table;
}

}    // namespace raceway
