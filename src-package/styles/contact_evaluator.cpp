// SPDX-License-Identifier: GPL-2.0-or-later
#include "contact_evaluator.h"

#include "fix_bearing_state.h"

#include <algorithm>
#include <functional>

using namespace raceway;

namespace bearing {

// Four contacts in the lanes of vector registers, and room for the results of spare lanes.
struct ContactEvaluator::InLanes {
  ContactLanes four;
  ContactState state;
  ContactForces force;
  double kept[most_states];
};

ContactEvaluator::ContactEvaluator(LAMMPS_NS::LAMMPS *lmp) :
    Pointers(lmp), in_lanes_(std::make_shared<InLanes>())
{
}

void ContactEvaluator::set_order(const ContactTable &table)
{
  by_groove_.resize(table.raceway.size());
  for (size_t k = 0; k < by_groove_.size(); ++k) by_groove_[k] = static_cast<int>(k);
  std::stable_sort(by_groove_.begin(), by_groove_.end(), [&table](int a, int b) {
    const RacewayContact &one = table.raceway[a], &other = table.raceway[b];
    if (one.i_ring != other.i_ring) return one.i_ring < other.i_ring;
    return std::less<const RacewayPhysics *>()(one.raceway, other.raceway);
  });
}

void ContactEvaluator::evaluate(ContactTable &of, const Setting &set)
{
  std::vector<RacewayContact> &table = of.raceway;
  set_ = set;
  rows_ = table.data();
  found_.resize(table.size());
  flaws_.resize(set.profiled ? table.size() : 0);
  ContactLanes &four = in_lanes_->four;
  four.gaps = set.gaps;
  four.energies = set.energies;
  energies_.resize(four.energies ? table.size() : 0);
  std::fill(four.flaw, four.flaw + lanes, nullptr);
  four.flawed = false;
  const int end = static_cast<int>(table.size());
  for (int first = 0, next; first < end; first = next) {
    RacewayContact &of_all = table[by_groove_[first]];
    for (next = first + 1; next < end && same_groove(of_all, table[by_groove_[next]]);) ++next;
    const RacewayPhysics &p = *of_all.raceway;
    four.groove = groove_of(of_all);
    four.dt = advances(of_all) ? update->dt : 0.0;
    if (set.facts->decides) {    // the law has a nonzero reach, so contacts that touched before
                                 // come first
      near_.clear();
      for (const bool touched : {true, false})
        for (int n = first; n < next; ++n)
          if (table[by_groove_[n]].live == touched) near_.push_back(by_groove_[n]);
      if (!flaws_.empty())
        for (const int row : near_)
          if (table[row].flawed()) touch_profile(row);
    } else {
      find_near(first, next);
    }
    const int n = static_cast<int>(near_.size());
    for (int k = 0; k < n; k += lanes) {
      const int count = std::min(lanes, n - k);
      take(&near_[k], count);
      act_in_lanes(p, four);
      for (int i = 0; i < count; ++i) {
        table[near_[k + i]].live = four.live[i];
        if (four.energies) energies_[near_[k + i]] = four.energy[i];
      }
    }
  }
  for (RacewayContact &c : table) {
    if (set.gaps)
      c.orbit =
          dot(Vec3::from(atom->v[c.i_ball]) - Vec3::from(atom->v[c.i_ring]), c.state.t) / c.state.r;
    if (!c.live && advances(c)) std::fill(c.kept, c.kept + set.facts->states, 0.0);
  }
}

// Returns true if this step advances the state of a contact. During a set-up no state is advanced,
// because its forces belong to a step that is already complete. Contacts in the groups of fixes
// that advance the state themselves are also excluded.
bool ContactEvaluator::advances(const RacewayContact &c) const
{
  return !update->setupflag && !(atom->mask[c.i_ball] & set_.implicit_bits);
}

BallState ContactEvaluator::ball_of(const RacewayContact &c) const
{
  return {Vec3::from(atom->x[c.i_ball]), Vec3::from(atom->v[c.i_ball]),
          Vec3::from(atom->omega[c.i_ball])};
}

// Returns the state of the ring at the groove, which may be offset from the ring's mid-plane.
RingState ContactEvaluator::groove_of(const RacewayContact &c) const
{
  RingState ring = {Vec3::from(atom->x[c.i_ring]), Vec3::from(atom->v[c.i_ring]),
                    Vec3::from(atom->omega[c.i_ring]), set_.state->axis(c.i_ring)};
  if (c.raceway->groove.offset != 0.0) {
    const Vec3 arm = ring.e * c.raceway->groove.offset;
    ring.x += arm;
    ring.v += cross(ring.w, arm);
  }
  return ring;
}

// Finds the possible contacts of one groove, whose rows are the entries `first` to `end` of
// by_groove_.
void ContactEvaluator::find_near(int first, int end)
{
  near_.clear();
  ContactLanes &four = in_lanes_->four;
  for (int n = first; n < end; n += lanes) {
    const int count = std::min(lanes, end - n);
    take(&by_groove_[n], count);
    find_places(*rows_[by_groove_[n]].raceway, four);
    for (int i = 0; i < count; ++i) {
      const int row = by_groove_[n + i];
      RacewayContact &c = rows_[row];
      c.live = flaws_.empty() || !c.flawed() ? four.live[i] : touch_profile(row);
      if (c.live) near_.push_back(row);
    }
  }
}

// Loads rows of the table into the lanes. Spare lanes copy the ball of the first lane, and their
// results are discarded.
void ContactEvaluator::take(const int *rows, int count)
{
  InLanes &room = *in_lanes_;
  ContactLanes &four = room.four;
  for (int i = 0; i < count; ++i) {
    RacewayContact &c = rows_[rows[i]];
    four.ball[i] = {atom->x[c.i_ball], atom->v[c.i_ball], atom->omega[c.i_ball]};
    four.kept[i] = c.kept;
    four.state[i] = &c.state;
    four.force[i] = &found_[rows[i]];
  }
  for (int i = count; i < lanes; ++i) {
    four.ball[i] = four.ball[0];
    std::copy(four.kept[0], four.kept[0] + set_.facts->states, room.kept);
    four.kept[i] = room.kept;
    four.state[i] = &room.state;
    four.force[i] = &room.force;
  }
  if (flaws_.empty()) return;
  four.flawed = false;
  for (int i = 0; i < lanes; ++i) {
    four.flaw[i] = i < count && rows_[rows[i]].flawed() ? &flaws_[rows[i]] : nullptr;
    four.flawed |= four.flaw[i] != nullptr;
  }
}

// Locates a contact whose raceway or ball has a profile. Returns true if the surfaces may touch.
bool ContactEvaluator::touch_profile(int row)
{
  RacewayContact &c = rows_[row];
  const RingState ring = groove_of(c);
  const BallState ball = ball_of(c);
  ContactState &s = c.state;
  locate(ball.x - ring.x, ring.e, c.raceway->centre_circle, s);
  out_of_reach(*c.raceway, s);
  const LabAxes axes = {set_.axis};
  const Vec3 u = axes.third(s.u);
  BallView view;
  if (c.ball_profile) {
    const Quaternion to_ball = set_.state->turn(c.i_ball).back();
    view = {to_ball(axes.third(s.u * s.nu + ring.e * s.ne)), to_ball(axes.third(s.t)),
            to_ball(axes.third(ring.e * s.nu - s.u * s.ne))};
  }
  FlawedPlace &flaw = flaws_[row];
  flaw.ring = c.profile;
  flaw.ball = c.ball_profile;
  flaw.on = profiled(c.profile, c.ball_profile, *c.raceway,
                     std::atan2(u.y, u.x) - set_.state->angle(c.i_ring), s.r, s.overlap, view,
                     flaw.turned);
  s.overlap = flaw.on.overlap;
  const bool touches = !(s.overlap <= -c.raceway->reach);
  if (set_.gaps && !touches)
    find_motions<false>(*c.raceway, BallState{ball.x - ring.x, ball.v, ball.w}, ring, s);
  return touches;
}

}    // namespace bearing
