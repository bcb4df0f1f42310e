// SPDX-License-Identifier: GPL-2.0-or-later
// The step: fill the contact table, add forces.
#include "pair_bearing_hertz.h"

#include "../core/contact/contact_lanes.h"
#include "../core/laws/damped_hertz.h"
#include "../core/settings/arguments.h"
#include "fix_bearing_state.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
using bearing::SphereContact;
using bearing::text;

// Four contacts in lanes, and results of lanes without a contact.
struct PairBearingHertz::InLanes {
  ContactLanes four;
  ContactState state;
  ContactForces force;
  double kept[most_states];
};

void PairBearingHertz::compute(int eflag, int vflag)
{
  BRG_EV_INIT(eflag, vflag);
  state_->forward_axes();
  if (neighbor->ago == 0 || rebuild_) rebuild_contacts();
  ++fills_;
  raceway_forces();
  sphere_forces(evflag);
  ring_sum_.flush();
}

// Evaluates possible contacts of one groove, four at a time. Forces are added in the table's order.
void PairBearingHertz::raceway_forces()
{
  std::vector<RacewayContact> &table = table_.raceway;
  found_.resize(table.size());
  flaws_.resize(smooth() ? 0 : table.size());
  if (!in_lanes_) in_lanes_ = std::make_shared<InLanes>();
  ContactLanes &four = in_lanes_->four;
  four.gaps = gaps_;
  four.energies = evflag && eflag_either;
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
    if (facts_.decides) {    // a law with a reach: those that touched before come first
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
  for (size_t n = 0; n < table.size(); ++n) {
    RacewayContact &c = table[n];
    if (gaps_) c.orbit = orbit_of(c);
    if (c.live) {
      if (!(c.state.overlap < c.raceway->largest_overlap)) lost(c);
      add_forces(c, found_[n], four.energies ? energies_[n] : 0.0);
    } else if (advances(c)) {
      std::fill(c.kept, c.kept + facts_.states, 0.0);
    }
  }
}

void PairBearingHertz::add_forces(const RacewayContact &c, const ContactForces &forces,
                                  double energy)
{
  if (!std::isfinite(c.state.normal)) lost(c);
  forces.force.add_to(atom->f[c.i_ball]);
  forces.ball_torque.add_to(atom->torque[c.i_ball]);
  ring_sum_.add(c.claim, -forces.force, forces.ring_torque);
  if (evflag) tally(c, forces, energy);
}

double PairBearingHertz::orbit_of(const RacewayContact &c) const
{
  return dot(Vec3::from(atom->v[c.i_ball]) - Vec3::from(atom->v[c.i_ring]), c.state.t) / c.state.r;
}

// True if this step advances the state of a contact. The forces of a set-up belong to a completed
// step; groups of fixes that advance the state themselves are excluded.
bool PairBearingHertz::advances(const RacewayContact &c) const
{
  return !update->setupflag && !(atom->mask[c.i_ball] & implicit_bits_);
}

BallState PairBearingHertz::ball_of(const RacewayContact &c) const
{
  return {Vec3::from(atom->x[c.i_ball]), Vec3::from(atom->v[c.i_ball]),
          Vec3::from(atom->omega[c.i_ball])};
}

// Ring state at the groove, which may be offset from the ring's mid-plane.
RingState PairBearingHertz::groove_of(const RacewayContact &c) const
{
  RingState ring = {Vec3::from(atom->x[c.i_ring]), Vec3::from(atom->v[c.i_ring]),
                    Vec3::from(atom->omega[c.i_ring]), state_->axis(c.i_ring)};
  if (c.raceway->groove.offset != 0.0) {
    const Vec3 arm = ring.e * c.raceway->groove.offset;
    ring.x += arm;
    ring.v += cross(ring.w, arm);
  }
  return ring;
}

// Finds the possible contacts among those of one groove, entries `first` to `end` of by_groove_.
void PairBearingHertz::find_near(int first, int end)
{
  near_.clear();
  ContactLanes &four = in_lanes_->four;
  for (int n = first; n < end; n += lanes) {
    const int count = std::min(lanes, end - n);
    take(&by_groove_[n], count);
    find_places(*table_.raceway[by_groove_[n]].raceway, four);
    for (int i = 0; i < count; ++i) {
      const int row = by_groove_[n + i];
      RacewayContact &c = table_.raceway[row];
      c.live = flaws_.empty() || !c.flawed() ? four.live[i] : touch_profile(row);
      if (c.live) near_.push_back(row);
    }
  }
}

// Loads rows of the table into the lanes. Spare lanes copy the ball of the first one, and their
// results are discarded.
void PairBearingHertz::take(const int *rows, int count)
{
  InLanes &room = *in_lanes_;
  ContactLanes &four = room.four;
  for (int i = 0; i < count; ++i) {
    RacewayContact &c = table_.raceway[rows[i]];
    four.ball[i] = {atom->x[c.i_ball], atom->v[c.i_ball], atom->omega[c.i_ball]};
    four.kept[i] = c.kept;
    four.state[i] = &c.state;
    four.force[i] = &found_[rows[i]];
  }
  for (int i = count; i < lanes; ++i) {
    four.ball[i] = four.ball[0];
    std::copy(four.kept[0], four.kept[0] + facts_.states, room.kept);
    four.kept[i] = room.kept;
    four.state[i] = &room.state;
    four.force[i] = &room.force;
  }
  if (flaws_.empty()) return;
  four.flawed = false;
  for (int i = 0; i < lanes; ++i) {
    four.flaw[i] = i < count && table_.raceway[rows[i]].flawed() ? &flaws_[rows[i]] : nullptr;
    four.flawed |= four.flaw[i] != nullptr;
  }
}

void PairBearingHertz::tally(const RacewayContact &c, const ContactForces &forces, double energy)
{
  const Vec3 d = Vec3::from(atom->x[c.i_ball]) - groove_of(c).x;
  // only this rank sees the pair: count it whole (newton = 1)
  ev_tally_xyz(c.i_ball, c.i_ring, atom->nlocal, 1, eflag_either ? energy : 0.0, 0.0,
               forces.force.x, forces.force.y, forces.force.z, d.x, d.y, d.z);
}

// Position of a contact whose raceway or ball has a profile; true if it may touch.
bool PairBearingHertz::touch_profile(int row)
{
  RacewayContact &c = table_.raceway[row];
  const RingState ring = groove_of(c);
  const BallState ball = ball_of(c);
  ContactState &s = c.state;
  locate(ball.x - ring.x, ring.e, c.raceway->centre_circle, s);
  out_of_reach(*c.raceway, s);
  const LabAxes axes = {axis_};
  const Vec3 u = axes.third(s.u);
  BallView view;
  if (c.ball_profile) {
    const Quaternion to_ball = state_->turn(c.i_ball).back();
    view = {to_ball(axes.third(s.u * s.nu + ring.e * s.ne)), to_ball(axes.third(s.t)),
            to_ball(axes.third(ring.e * s.nu - s.u * s.ne))};
  }
  FlawedPlace &flaw = flaws_[row];
  flaw.ring = c.profile;
  flaw.ball = c.ball_profile;
  flaw.on =
      profiled(c.profile, c.ball_profile, *c.raceway,
               std::atan2(u.y, u.x) - state_->angle(c.i_ring), s.r, s.overlap, view, flaw.turned);
  s.overlap = flaw.on.overlap;
  const bool touches = !(s.overlap <= -c.raceway->reach);
  if (gaps_ && !touches)
    find_motions<false>(*c.raceway, BallState{ball.x - ring.x, ball.v, ball.w}, ring, s);
  return touches;
}

void PairBearingHertz::sphere_forces(bool tally)
{
  double **x = atom->x, **v = atom->v, **f = atom->f;
  const int nlocal = atom->nlocal;
  for (SphereContact &s : table_.sphere) {
    const Vec3 d = Vec3::from(x[s.i]) - Vec3::from(x[s.j]);
    const double r2 = dot(d, d);
    if (r2 >= s.reach * s.reach) {
      s.stiffness = s.damping = s.force = s.loss = 0.0;
      continue;
    }
    const double r = std::sqrt(r2);
    const Vec3 n = d * (1.0 / r), dv = Vec3::from(v[s.i]) - Vec3::from(v[s.j]);
    const double overlap = s.reach - r, rate = -dot(dv, n);
    const DampedHertz h = damped_hertz(s.K, overlap, rate, s.mass);
    s.stiffness = h.stiffness;
    s.damping = h.damping;
    s.force = h.force;
    s.loss = damping_loss(h, overlap, rate);
    const Vec3 force = n * h.force;
    if (s.i < nlocal) force.add_to(f[s.i]);
    if (s.j < nlocal) (-force).add_to(f[s.j]);
    if (tally) {
      const double energy =
          eflag_either ? 0.4 * s.K * (s.reach - r) * (s.reach - r) * std::sqrt(s.reach - r) : 0.0;
      ev_tally_xyz(s.i, s.j, nlocal, 0, energy, 0.0, force.x, force.y, force.z, d.x, d.y, d.z);
    }
  }
}

void PairBearingHertz::lost(const RacewayContact &c)
{
  BRG_ONE("ball " + std::to_string(c.ball) + " on " +
          (c.side() == Side::inner ? "inner" : "outer") + " ring " + std::to_string(c.ring) +
          (c.raceway->groove.offset != 0.0 ? " in groove " + std::to_string(c.groove()) : "") +
          " at step " + std::to_string(update->ntimestep) + ": overlap " + text(c.state.overlap) +
          " m, force " + text(c.state.normal) + " N, largest allowed overlap " +
          text(c.raceway->largest_overlap) + " m (" + c.raceway->limit() + "). The step " +
          text(update->dt) + " s is too large, the load too high, or the start overlaps");
  std::abort();
}
