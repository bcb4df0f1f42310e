// SPDX-License-Identifier: GPL-2.0-or-later
#include "capacitor_table.h"

#include <algorithm>
#include <map>

using namespace raceway;

namespace bearing {

void CapacitorTable::plan(const ContactTable &table, const CapacitorModel &model,
                          const std::function<bool(const RacewayContact &)> &counts)
{
  batches_.clear();
  of_.assign(table.raceway.size(), {});
  std::map<const RacewayPhysics *, size_t> known;
  for (size_t k = 0; k < table.raceway.size(); ++k) {
    const RacewayContact &c = table.raceway[k];
    if (!counts(c)) continue;
    const auto at = known.emplace(c.raceway, batches_.size());
    if (at.second) batches_.push_back({SurroundedRaceway(*c.raceway, model), {}});
    batches_[at.first->second].rows.push_back(static_cast<int>(k));
  }
}

// Contacts that touch are grouped, because evaluating four contacts of the same kind takes less
// time than evaluating a mix of open and closed ones.
void CapacitorTable::fill(const ContactTable &table)
{
  for (Batch &b : batches_) {
    std::partition(b.rows.begin(), b.rows.end(), [&](int k) { return table.raceway[k].live; });
    fill(table, b);
  }
}

RACEWAY_LANES void CapacitorTable::fill(const ContactTable &table, const Batch &batch)
{
  const int n = static_cast<int>(batch.rows.size());
  const RacewayPhysics &p = *batch.raceway.raceway();
  const bool slides = p.factors.any, gap = p.facts().film_in_gap;
  ContactStateT<Lane> c;
  for (int first = 0; first < n; first += lanes) {
    if (first + 1 == n) {    // a single contact takes less time than four
      const RacewayContact &one = table.raceway[batch.rows[first]];
      of_[batch.rows[first]] = batch.raceway.capacitor(one.state, one.live, one.orbit);
      break;
    }
    const RacewayContact *four[lanes];    // empty lanes are filled with the last contact
    for (int i = 0; i < lanes; ++i)
      four[i] = &table.raceway[batch.rows[std::min(first + i, n - 1)]];
    const auto take = [&four](auto of) __attribute__((always_inline)) {
      return Lane{of(*four[0]), of(*four[1]), of(*four[2]), of(*four[3])};
    };
    using One = const RacewayContact &;
    c.cos_angle = take([](One one) { return one.state.cos_angle; });
    c.overlap = take([](One one) { return one.state.overlap; });
    c.root = take([](One one) { return one.state.root; });
    c.entrainment = take([](One one) { return one.state.entrainment; });
    c.film_load = take([](One one) { return one.state.film_load; });
    if (any(c.cos_angle < 1.0)) {
      c.nu = take([](One one) { return one.state.nu; });
      c.ne = take([](One one) { return one.state.ne; });
    }
    if (slides) {
      c.sliding_t = take([](One one) { return one.state.sliding_t; });
      c.sliding_w = take([](One one) { return one.state.sliding_w; });
    }
    if (gap) {
      c.load = take([](One one) { return one.state.load; });
      c.h_c = take([](One one) { return one.state.h_c; });
    }
    const Lane orbit = take([](One one) { return one.orbit; });
    const LaneMask live = take([](One one) { return double(one.live); }) > 0.0;
    const FilmCapacitorT<Lane> found = batch.raceway.capacitor(c, live, orbit);
    for (int i = 0; i < lanes && first + i < n; ++i)
      of_[batch.rows[first + i]] = {found.h_c[i], found.capacitance[i], found.separation[i],
                                    found.outside[i]};
  }
}

}    // namespace bearing
