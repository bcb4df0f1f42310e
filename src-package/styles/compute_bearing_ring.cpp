// SPDX-License-Identifier: GPL-2.0-or-later
#include "compute_bearing_ring.h"

#include "../core/figures/bearing_columns.h"
#include "contact_context.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"
#include "ring_values.h"

#include <cstring>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::BallFigures;
using bearing::BearingFigures;
using bearing::Figure;
using bearing::RacewayContact;
using bearing::RingSum;
namespace of_ring = bearing::of_ring;

// Values that a contact sends to its ring: its results, followed by the unit vector of the orbital
// direction divided by the radius.
static constexpr size_t ALONG = BallFigures::numbers(), N_SAID = ALONG + 3;

// compute ID group bearing/ring all|value ...
ComputeBearingRing::ComputeBearingRing(BRG_COMPUTE_ARGS) :
    BRG_COMPUTE_BASE, pair_(PairBearingHertz::find(lmp, "compute bearing/ring"))
{
  bearing::Arguments args(lmp, std::string("compute ") + id + " bearing/ring", narg, arg,
                          BRG_COMPUTE_FIRST);
  const bearing::Offer offer = bearing::offer_of(lmp, *pair_);
  const std::vector<Figure> &figures = bearing::ring_figures();
  do {
    const std::string name = args.word("a value");
    if (name == "all") {
      for (int k = 0; k < of_ring::N; ++k) columns_.push_back({of_ring::list[k], k, nullptr});
      for (const Figure &f : figures)
        if (f.given(offer.film, offer.capacitance, offer.surroundings, pair_->coefficients().law(),
                    false))
          columns_.push_back({f.is, -1, &f});
      continue;
    }
    const size_t before = columns_.size();
    for (int k = 0; k < of_ring::N; ++k)
      if (name == of_ring::list[k].name) columns_.push_back({of_ring::list[k], k, nullptr});
    for (const Figure &f : figures)
      if (name == f.is.name) columns_.push_back({f.is, -1, &f});
    if (columns_.size() == before) {
      std::string known = "all";
      for (const raceway::Column &c : of_ring::list) known += ", " + std::string(c.name);
      for (const Figure &f : figures) known += ", " + std::string(f.is.name);
      args.fail("unknown value '" + name + "'; known: " + known);
    }
    const Figure *f = columns_.back().figure;
    if (f && f->needs != Needs::nothing && !pair_->coefficients().lubricated())
      args.fail("value '" + name + "' " + bearing::needs_lubricant);
  } while (args.more());
  local_flag = 1;
  size_local_rows = 0;
  // the host expects a vector if there is one column, and an array if there are several
  size_local_cols = columns_.size() == 1 ? 0 : static_cast<int>(columns_.size());
}

void ComputeBearingRing::init()
{
  const std::string name = std::string("compute ") + id + " bearing/ring";
  pair_ = PairBearingHertz::find(lmp, name);
  capacitor_ = nullptr;
  for (const Output &c : columns_) {
    const std::string wants = std::string("value '") + c.is.name + "'";
    if (!c.figure || c.figure->needs < Needs::capacitance) continue;
    capacitor_ = bearing::capacitor_of(lmp, name, wants);
    if (c.figure->needs == Needs::surroundings)
      bearing::check_surroundings(lmp, *pair_, name, wants);
  }
}

// Sets the values of each claim, i.e. of the index under which a contact sends data to the owner of
// its ring.
void ComputeBearingRing::tell()
{
  said_.assign(static_cast<size_t>(pair_->ring_sum().claims()) * N_SAID, 0.0);
  const std::vector<RacewayContact> &table = pair_->table().raceway;
  const bearing::ContactContext context = {pair_->coefficients().axis_index(), capacitor_};
  for (size_t first = 0, end; first < table.size(); first = end) {
    BallFigures ball;    // totals over all rings
    std::vector<BallFigures> each;
    for (end = first; end < table.size() && table[end].ball == table[first].ball; ++end) {
      const bearing::ContactView view = context.view(table[end]);
      each.emplace_back();
      if (table[end].live) each.back().contact(view);
      if (table[end].live) ball.contact(view);
      else if (capacitor_) ball.gap(view);
    }
    for (size_t k = first; k < end; ++k) {
      const RacewayContact &c = table[k];
      BallFigures &own = each[k - first];
      // results that combine both contacts of a ball are counted only once per ball and ring
      if (k == first || table[k - 1].ring != c.ring) own.take_pairs(ball);
      else own.take_pairs(BallFigures());
      // the owner subtracts the ring's velocity, because the velocity of a ghost is half a step old
      const GroovePosition g = locate(Vec3::from(atom->x[c.i_ball]) - Vec3::from(atom->x[c.i_ring]),
                                      pair_->state()->axis(c.i_ring), c.raceway->centre_circle);
      own.balls = 1.0;
      own.orbit = dot(Vec3::from(atom->v[c.i_ball]), g.t) / g.r;
      double *said = &said_[static_cast<size_t>(c.claim) * N_SAID];
      memcpy(said, &own, sizeof own);
      (g.t * (1.0 / g.r)).to(said + ALONG);
    }
  }
}

void ComputeBearingRing::compute_local()
{
  invoked_local = update->ntimestep;
  pair_ = PairBearingHertz::find(
      lmp, "compute bearing/ring");    // the pair style may have been replaced between runs
  tell();
  const RingSum &rings = pair_->ring_sum();
  std::vector<BearingFigures> sums(rings.rings());
  pair_->ring_sum().collect(N_SAID, said_, [&](int n, RingSum::Source source, const double *said) {
    if (source != RingSum::ball) return;
    BallFigures ball;
    memcpy(static_cast<void *>(&ball), said, sizeof ball);
    ball.orbit -= dot(Vec3::from(atom->v[rings.ring(n)]), Vec3::from(said + ALONG));
    sums[n].add(ball);
  });

  values_.clear();
  bearing::note_setup(lmp);
  for (int n = 0; n < rings.rings(); ++n) {
    if (!(atom->mask[rings.ring(n)] & groupbit)) continue;
    double motion[of_ring::N];
    bearing::ring_values(*atom, *pair_, n, motion);
    for (const Output &c : columns_)
      values_.push_back(c.figure ? c.figure->value(sums[n]) : motion[c.motion]);
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
  for (const Output &c : columns_) list.push_back({c.is.name, c.is.format});
  return list;
}

double ComputeBearingRing::memory_usage()
{
  return (said_.capacity() + values_.capacity()) * sizeof(double) +
         rows_.capacity() * sizeof(double *);
}
