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

void CapacitorTable::fill(const ContactTable &table)
{
  for (const Batch &b : batches_) fill(table, b);
}

RACEWAY_LANES void CapacitorTable::fill(const ContactTable &table, const Batch &batch)
{
  const int n = static_cast<int>(batch.rows.size());
  ContactStateT<Lane> c;
  Lane orbit = {}, live = {};
  for (int first = 0; first < n; first += lanes) {
    for (int i = 0; i < lanes; ++i) {    // the last one fills up
      const RacewayContact &one = table.raceway[batch.rows[std::min(first + i, n - 1)]];
      c.nu[i] = one.state.nu;
      c.ne[i] = one.state.ne;
      c.cos_angle[i] = one.state.cos_angle;
      c.overlap[i] = one.state.overlap;
      c.root[i] = one.state.root;
      c.entrainment[i] = one.state.entrainment;
      c.film_load[i] = one.state.film_load;
      orbit[i] = one.orbit;
      live[i] = one.live;
    }
    const FilmCapacitorT<Lane> found = batch.raceway.capacitor(c, live > 0.0, orbit);
    for (int i = 0; i < lanes && first + i < n; ++i)
      of_[batch.rows[first + i]] = {found.h_c[i], found.capacitance[i], found.separation[i],
                                    found.outside[i]};
  }
}

}    // namespace bearing
