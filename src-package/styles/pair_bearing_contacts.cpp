// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the possible contacts of balls with raceways, cage balls and other balls, once per
// neighbour build.
#include "pair_bearing_hertz.h"

#include "../core/settings/arguments.h"
#include "fix_bearing_state.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
using bearing::SphereContact;
using bearing::text;

void PairBearingHertz::rebuild_contacts()
{
  check_atoms();
  table_.raceway.clear();
  table_.sphere.clear();
  grains_.clear();
  const int nlocal = atom->nlocal, *type = atom->type;
  for (int ii = 0; ii < list->inum; ++ii) {
    const int i = list->ilist[ii];
    for (int jj = 0; jj < list->numneigh[i]; ++jj) {
      const int j = list->firstneigh[i][jj] & NEIGHMASK;
      if (coefficients_.is_ring(type[i]) || coefficients_.is_ring(type[j])) {
        const bool ring_first = coefficients_.is_ring(type[i]);
        // the rank that owns the ball adds the contact
        if ((ring_first ? j : i) < nlocal) add_grooves(ring_first ? j : i, ring_first ? i : j);
        continue;
      }
      if (coefficients_.grains(type[i], type[j])) {
        grains_.emplace_back(i, j);
        continue;
      }
      const bool i_first = atom->tag[i] < atom->tag[j];
      SphereContact s;
      s.i = i_first ? i : j;
      s.j = i_first ? j : i;
      s.tag_i = atom->tag[s.i];
      s.tag_j = atom->tag[s.j];
      s.reach = atom->radius[i] + atom->radius[j];
      const Vec3 d = Vec3::from(atom->x[i]) - Vec3::from(atom->x[j]);
      if (update->setupflag && norm(d) < 0.98 * s.reach)
        BRG_ONE("overlapping balls: atoms " + std::to_string(s.tag_i) + " and " +
                std::to_string(s.tag_j) + " are " + text(norm(d)) +
                " m apart, but the sum of their radii is " + text(s.reach) + " m");
      const auto *spheres = coefficients_.spheres(type[i], type[j]);
      if (!spheres) continue;
      s.K = spheres->stiffness(atom->radius[i], atom->radius[j]);
      s.mass = atom->rmass[i] * atom->rmass[j] / (atom->rmass[i] + atom->rmass[j]);
      table_.sphere.push_back(s);
    }
  }
  std::sort(table_.raceway.begin(), table_.raceway.end(),
            [](const RacewayContact &a, const RacewayContact &b) {
              if (a.ball != b.ball) return a.ball < b.ball;
              return a.ring != b.ring ? a.ring < b.ring : a.groove() < b.groove();
            });
  std::sort(table_.sphere.begin(), table_.sphere.end(),
            [](const SphereContact &a, const SphereContact &b) {
              return a.tag_i != b.tag_i ? a.tag_i < b.tag_i : a.tag_j < b.tag_j;
            });
  evaluator_.set_order(table_);
  add_raceway_contacts();
  rebuild_ = false;
  ++builds_;
}

// Adds the grooves of a ring that a ball may touch.
void PairBearingHertz::add_grooves(int i_ball, int i_ring)
{
  RacewayContact c;
  c.i_ball = i_ball;
  c.i_ring = i_ring;
  c.ball = atom->tag[i_ball];
  c.ring = atom->tag[i_ring];
  const Vec3 d = Vec3::from(atom->x[i_ball]) - Vec3::from(atom->x[i_ring]),
             &e = state_->axis(i_ring);
  for (int k = 0; (c.raceway = coefficients_.raceway(atom->type[i_ball], atom->type[i_ring], k));
       ++k) {
    const Groove &groove = c.raceway->groove;
    // balls of another bearing are not in this groove
    if (!(locate(d - e * groove.offset, e, c.raceway->centre_circle).s < groove.groove_radius))
      continue;
    if (profiles_.any()) {
      c.profile = profiles_.of_ring(c.ring, c.raceway);
      c.ball_profile = profiles_.of_ball(c.ball, c.raceway);
    }
    table_.raceway.push_back(c);
  }
}

// Sets the claims and states of the contacts. Stops with an error unless every ball is in exactly
// one ring on each side on which its type has a raceway.
void PairBearingHertz::add_raceway_contacts()
{
  std::vector<int> sides(atom->nlocal, 0);
  const RacewayContact *before = nullptr;
  for (RacewayContact &c : table_.raceway) {
    c.claim = ring_sum_.claim(c.ring, state_->owner(c.i_ring), bearing::RingSum::ball, c.ball);
    c.kept = state_->kept(c.i_ball, c.ring, c.groove());
    const int bit = c.side() == Side::inner ? 1 : 2;
    const bool other_ring = !before || before->ball != c.ball || before->ring != c.ring;
    before = &c;
    if (other_ring && (sides[c.i_ball] & bit))
      BRG_ONE("ball " + std::to_string(c.ball) + " sits in the grooves of two " +
              (bit == 1 ? "inner" : "outer") +
              " rings: two bearings overlap, or a ring exists twice");
    sides[c.i_ball] |= bit;
  }
  for (int i = 0; i < atom->nlocal; ++i) {
    const int missing = coefficients_.sides_of(atom->type[i]) & ~sides[i];
    if (missing)
      BRG_ONE(
          std::string(update->setupflag ? "ball " : "lost ball ") + std::to_string(atom->tag[i]) +
          " at (" + text(atom->x[i][0]) + ", " + text(atom->x[i][1]) + ", " + text(atom->x[i][2]) +
          ") m is not in any groove of an " + (missing & 1 ? "inner" : "outer") + " ring at step " +
          std::to_string(update->ntimestep) +
          (update->setupflag
               ? ": the ring is missing, at another position or at odds with the other ring"
               : ": the step is too large, the load is too high, or the rings have come apart"));
  }
}
