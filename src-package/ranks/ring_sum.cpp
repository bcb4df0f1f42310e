// SPDX-License-Identifier: GPL-2.0-or-later
#include "ring_sum.h"

#include "exchange.h"
#include "letters.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::Vec3;

namespace bearing {

static constexpr int sum_letters = 6209;    // MPI message tag, used only in this file

void RingSum::reset()
{
  claims_.clear();
  owner_.clear();
  shares_.clear();
  rings_.clear();
  ways_known_ = false;
}

void RingSum::own(int i_ring, tag_t ring)
{
  rings_.push_back({i_ring, ring, true, {}, Vec3(), Vec3(), {}});
}

int RingSum::claim(tag_t ring, int owner, Source source, tag_t partner)
{
  if (ways_known_)
    BRG_ONE("ring " + std::to_string(ring) + ": atom " + std::to_string(partner) +
            " comes after the forces of the step were added: please report this");
  claims_.push_back({ring, partner, source});
  owner_.push_back(owner);
  shares_.push_back({{}, -1});
  return claims() - 1;
}

// Sets up the messages between ranks and the ordered list of the terms in the sum over every ring.
void RingSum::find_ways()
{
  const int np = comm->nprocs, me = comm->me;
  std::sort(rings_.begin(), rings_.end(),
            [](const OwnedRing &a, const OwnedRing &b) { return a.tag < b.tag; });
  auto ring_of = [this](tag_t tag) {
    const auto r = std::lower_bound(rings_.begin(), rings_.end(), tag,
                                    [](const OwnedRing &a, tag_t t) { return a.tag < t; });
    if (r == rings_.end() || r->tag != tag)
      BRG_ONE("ring " + std::to_string(tag) +
              " is not on the rank it should be on: please report this");
    return static_cast<int>(r - rings_.begin());
  };
  std::vector<std::vector<Claim>> to(np);
  std::vector<std::vector<int>> numbers(np);
  for (int k = 0; k < claims(); ++k) {
    if (owner_[k] == me) {
      rings_[ring_of(claims_[k].ring)].terms.push_back(
          {claims_[k].partner, claims_[k].source, -1, k});
    } else {
      to[owner_[k]].push_back(claims_[k]);
      numbers[owner_[k]].push_back(k);
    }
  }
  const std::vector<std::vector<Claim>> from = bearing::exchange(to, world);
  out_.clear();
  in_.clear();
  for (int p = 0; p < np; ++p) {
    if (p == me) continue;
    if (!numbers[p].empty())
      out_.push_back({p, numbers[p], static_cast<int>(numbers[p].size()), {}});
    if (from[p].empty()) continue;
    for (size_t at = 0; at < from[p].size(); ++at) {
      OwnedRing &r = rings_[ring_of(from[p][at].ring)];
      r.terms.push_back({from[p][at].partner, from[p][at].source, static_cast<int>(in_.size()),
                         static_cast<int>(at)});
      r.local = false;
    }
    in_.push_back({p, {}, static_cast<int>(from[p].size()), {}});
  }
  for (OwnedRing &r : rings_)
    std::stable_sort(r.terms.begin(), r.terms.end(), [](const Term &a, const Term &b) {
      return a.source != b.source ? a.source < b.source : a.partner < b.partner;
    });
  ways_known_ = true;
}

// Sends said(claim), i.e. `width` numbers for each claim, to the owners of the rings.
template <class Said> void RingSum::send(int width, Said said)
{
  for (Letter &l : out_) {
    l.text.resize(static_cast<size_t>(l.terms) * width);
    double *at = l.text.data();
    for (int k : l.claims) {
      std::copy(said(k), said(k) + width, at);
      at += width;
    }
  }
  for (Letter &l : in_) l.text.resize(static_cast<size_t>(l.terms) * width);
  deliver(out_, in_, sum_letters, world);
}

void RingSum::flush()
{
  const bool first = !ways_known_;    // nothing has been added directly to a ring yet
  if (first) find_ways();
  send(force_and_torque, [this](int k) { return shares_[k].said; });
  for (size_t n = 0; n < rings_.size(); ++n) {
    OwnedRing &r = rings_[n];
    if (first || !r.local)
      for (const Term &t : r.terms) {
        const double *said =
            t.letter < 0 ? shares_[t.at].said : &in_[t.letter].text[t.at * force_and_torque];
        r.force += Vec3::from(said);
        r.torque += Vec3::from(said + 3);
      }
    r.force.add_to(atom->f[r.i]);
    r.torque.add_to(atom->torque[r.i]);
    r.summed[0] = r.force;
    r.summed[1] = r.torque;
    r.force = r.torque = Vec3();
    if (first && r.local)
      for (const Term &t : r.terms) shares_[t.at].direct = static_cast<int>(n);
  }
  for (const Letter &l : out_)
    for (int k : l.claims) std::fill(shares_[k].said, shares_[k].said + force_and_torque, 0.0);
  for (const OwnedRing &r : rings_)
    if (!r.local)
      for (const Term &t : r.terms)
        if (t.letter < 0) std::fill(shares_[t.at].said, shares_[t.at].said + force_and_torque, 0.0);
}

void RingSum::collect(int width, const std::vector<double> &said,
                      const std::function<void(int, Source, const double *)> &heard)
{
  send(width, [&](int k) { return &said[static_cast<size_t>(k) * width]; });
  for (int n = 0; n < rings(); ++n)
    for (const Term &t : rings_[n].terms)
      heard(n, static_cast<Source>(t.source),
            (t.letter < 0 ? said.data() : in_[t.letter].text.data()) +
                static_cast<size_t>(t.at) * width);
}

}    // namespace bearing
