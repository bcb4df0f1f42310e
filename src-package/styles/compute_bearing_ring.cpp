// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_ring.h"

#include "../contacts/bearing_columns.h"
#include "../physics/contact.h"
#include "contact_context.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"
#include "ring_values.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
using bearing::RingSum;
namespace of_ring = bearing::of_ring;

namespace {

// What a contact says about its ring.
enum Said {
  LIVE,
  LOADED,
  LOAD,
  PRESSURE,
  H_MIN,
  LAMBDA,
  FRICTION,
  DAMPING,
  CAPACITANCE,
  CAPACITANCE_TOTAL,
  ORBIT,
  ALONG,
  N_SAID = ALONG + 3
};

}    // namespace

// compute ID group bearing/ring all|value ...
ComputeBearingRing::ComputeBearingRing(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/ring"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/ring", narg, arg,
                          BRG_COMPUTE_FIRST);
  const bearing::Offer offer = bearing::offer_of(lmp, *pair_);
  do {
    const std::string name = args.word("a value");
    if (name == "all") {
      for (int k = 0; k < of_ring::N; ++k)
        if (k == of_ring::CAPACITANCE         ? offer.capacitance
            : k == of_ring::CAPACITANCE_TOTAL ? offer.surroundings
                                              : offer.film || !of_ring::needs_film(k))
          columns_.push_back(k);
      continue;
    }
    int k = 0;
    while (k < of_ring::N && name != of_ring::list[k].name) ++k;
    if (k == of_ring::N) {
      std::string known;
      for (const raceway::Column &c : of_ring::list)
        known += (known.empty() ? "" : ", ") + std::string(c.name);
      args.fail("unknown value '" + name + "'; known: all, " + known);
    }
    if (of_ring::needs_film(k) && !pair_->lubricated())
      args.fail("value '" + name + "' needs a lubricant: use pair_style bearing/ehd");
    columns_.push_back(k);
  } while (args.more());
  local_flag = 1;
  size_local_rows = 0;
  // one column is a vector to the host, several are an array
  size_local_cols = columns_.size() == 1 ? 0 : static_cast<int>(columns_.size());
}

void ComputeBearingRing::init()
{
  const std::string name = std::string("compute ") + id + " bearing/ring";
  pair_ = PairBearingHertz::find(lmp, name);
  capacitor_ = nullptr;
  for (int k : columns_) {
    const std::string wants = std::string("value '") + of_ring::list[k].name + "'";
    if (of_ring::needs_capacitance(k)) capacitor_ = bearing::capacitor_of(lmp, name, wants);
    if (k == of_ring::CAPACITANCE_TOTAL) bearing::check_surroundings(lmp, *pair_, name, wants);
  }
}

// By claim, which is how a contact reaches the owner of its ring.
void ComputeBearingRing::tell()
{
  said_.assign(static_cast<size_t>(pair_->ring_sum().claims()) * N_SAID, 0.0);
  const std::vector<RacewayContact> &table = pair_->table().raceway;
  for (size_t first = 0, end; first < table.size(); first = end) {
    double side[2] = {}, whole[2] = {};    // capacitance, inner and outer; with surroundings
    int loaded = 0;
    for (end = first; end < table.size() && table[end].ball == table[first].ball; ++end) {
      const RacewayContact &c = table[end];
      const int s = c.side() == Side::inner ? 0 : 1;
      if (c.live) loaded |= 1 << s;
      if (!capacitor_) continue;
      const FilmCapacitorT<double> of = capacitor_(c);
      if (c.live) side[s] += of.capacitance;
      whole[s] += of.total();
    }
    for (size_t k = first; k < end; ++k) {
      const RacewayContact &c = table[k];
      double *said = &said_[static_cast<size_t>(c.claim) * N_SAID];
      // the ring's own velocity is its owner's business: that of a ghost is half a step old
      const GroovePosition g = locate(Vec3::from(atom->x[c.i_ball]) - Vec3::from(atom->x[c.i_ring]),
                                      pair_->state()->axis(c.i_ring), c.raceway->centre_circle);
      said[ORBIT] = dot(Vec3::from(atom->v[c.i_ball]), g.t) / g.r;
      (g.t * (1.0 / g.r)).to(said + ALONG);
      if (k == first || table[k - 1].ring != c.ring) {    // once a ball and ring
        said[LOADED] = loaded == 3;
        said[CAPACITANCE] = series_capacitance(side[0], side[1]);
        said[CAPACITANCE_TOTAL] = series_capacitance(whole[0], whole[1]);
      }
      if (!c.live) continue;
      const ContactState &s = c.state;
      said[LIVE] = 1.0;
      said[LOAD] = s.load;
      said[PRESSURE] = c.raceway->law.at(s.cos_angle).p * s.root;
      said[H_MIN] = s.h_min;
      said[LAMBDA] = s.lambda;
      said[FRICTION] = friction_power(s);
      said[DAMPING] = NormalForcePart::loss(s);
    }
  }
}

void ComputeBearingRing::compute_local()
{
  invoked_local = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/ring");    // it may have been replaced between runs
  tell();
  const RingSum &rings = pair_->ring_sum();
  std::vector<double> of(static_cast<size_t>(rings.rings()) * of_ring::N, 0.0),
      balls(rings.rings(), 0.0);
  for (int n = 0; n < rings.rings(); ++n)
    bearing::ring_values(*atom, *pair_, n, &of[static_cast<size_t>(n) * of_ring::N]);
  pair_->ring_sum().collect(N_SAID, said_, [&](int n, RingSum::Source source, const double *said) {
    if (source != RingSum::ball) return;
    double *v = &of[static_cast<size_t>(n) * of_ring::N];
    balls[n] += 1.0;
    v[of_ring::ORBIT] +=
        said[ORBIT] - dot(Vec3::from(atom->v[rings.ring(n)]), Vec3::from(said + ALONG));
    v[of_ring::BALLS] += said[LOADED];
    v[of_ring::CAPACITANCE] += said[CAPACITANCE];
    v[of_ring::CAPACITANCE_TOTAL] += said[CAPACITANCE_TOTAL];
    if (said[LIVE] == 0.0) return;
    v[of_ring::LOAD] = std::max(v[of_ring::LOAD], said[LOAD]);
    v[of_ring::PRESSURE] = std::max(v[of_ring::PRESSURE], said[PRESSURE]);
    v[of_ring::H_MIN] =
        v[of_ring::CONTACTS] == 0.0 ? said[H_MIN] : std::min(v[of_ring::H_MIN], said[H_MIN]);
    v[of_ring::LAMBDA] =
        v[of_ring::CONTACTS] == 0.0 ? said[LAMBDA] : std::min(v[of_ring::LAMBDA], said[LAMBDA]);
    v[of_ring::CONTACTS] += 1.0;
    v[of_ring::FRICTION_POWER] += said[FRICTION];
    v[of_ring::DAMPING_POWER] += said[DAMPING];
  });

  values_.clear();
  for (int n = 0; n < rings.rings(); ++n) {
    if (!(atom->mask[rings.ring(n)] & groupbit)) continue;
    double *v = &of[static_cast<size_t>(n) * of_ring::N];
    if (balls[n] > 0.0) v[of_ring::ORBIT] /= balls[n];
    for (int k : columns_) values_.push_back(v[k]);
  }
  rows_.resize(values_.size() / columns_.size());
  for (size_t r = 0; r < rows_.size(); ++r) rows_[r] = &values_[r * columns_.size()];
  size_local_rows = static_cast<int>(rows_.size());
  vector_local = values_.data();
  array_local = rows_.data();
}

std::vector<bearing::ColumnList::Item> ComputeBearingRing::columns() const
{
  std::vector<Item> list;
  for (int k : columns_) list.push_back({of_ring::list[k].name, of_ring::list[k].format});
  return list;
}

double ComputeBearingRing::memory_usage()
{
  return (said_.capacity() + values_.capacity()) * sizeof(double) +
         rows_.capacity() * sizeof(double *);
}
