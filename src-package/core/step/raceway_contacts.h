// SPDX-License-Identifier: GPL-2.0-or-later
// Evaluates the contacts of balls with raceways in groups of four, in the rotating frame of each
// ball. The contact law can be any class with the members of AnyLaw (core/contact/any_law.h); this
// file does not depend on the parts of the law.
//
// For smooth raceways, the loop is compiled once for each law in inputs/models, with the law
// inlined. It is also compiled once with an indirect law, which serves any set of parts and
// raceways with profiles.
#pragma once

#include "../bodies/ring_motions.h"
#include "../contact/any_law.h"
#include "bearing_forces.h"
#include "contact_rows.h"
#include "profile_rows.h"

#include <algorithm>

namespace raceway {

// Adds the contact to the matrix of the linear system, i.e. to the ball's block, the ring's columns
// and rows, and the border. d is the ball's position relative to the ring's centre.
template <int n>
static RACEWAY_INLINE void add_matrix(BearingSystem &system, BodyGroup &g, int group,
                                      const RingBody &ring, double R, const Vec3L &d,
                                      const Vec3L &e, const ScaledSlopes<n> &s,
                                      const ProfiledContactT<Lane> *on, const TurnRowT<Lane> *depth)
{
  Lane row[n][6], column[6][n];    // column[k]: local forces per unit of the ball's k-th velocity
                                   // component
  ball_rows(s, R, row);
  if (on)
    for (int k = 0; k < 3; ++k) row[0][k] -= on->slope * row[1][k];
  if (depth) {
    Lane change[6];
    depth->v.to(change);
    depth->w.to(change + 3);
    for (int k = 0; k < 6; ++k) row[0][k] -= change[k];
  }
  for (int k = 0; k < 6; ++k) {
    Lane motion[n];
    for (int i = 0; i < n; ++i) motion[i] = row[i][k];
    local_forces(s, motion, k < 3, column[k]);
    for (int m = 0; m < 6; ++m) {
      Lane a = row[m < 3 ? 0 : 1][m] * column[k][m < 3 ? 0 : 1];
      for (int i = m < 3 ? 1 : 2; i < n; ++i) a += row[i][m] * column[k][i];
      if (depth && m >= 3) a += row[0][m] * column[k][0];
      g.A[6 * m + k] += a;
    }
  }
  if (!ring.loose) return;
  g.coupled = true;
  const Vec3L lever = lever_of(ring, e, d + s.normal * R);
  Lane motions[RingProgram::N_DOF][n];
  int dofs[RingProgram::N_DOF], free = 0;
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    if (ring.column[dof] < 0) continue;
    const Vec3L v = motion_of(dof, g.now, e, lever);
    Lane(&m)[n] = motions[free];
    dofs[free++] = dof;
    m[0] = dot(s.normal, v);
    m[1] = dot(s.along, v);
    m[2] = dot(s.across, v);
    if (on) m[0] -= on->slope * dot(s.along, motion_of(dof, g.now, e, lever_of(ring, e, d)));
    if (depth)
      m[0] -= dot(depth->v, motion_of(dof, g.now, e, lever_of(ring, e, d))) +
              dot(depth->w, rotation_of(dof, g.now, e));
    if constexpr (n == 6) {
      const Vec3L w = rotation_of(dof, g.now, e);
      m[3] = dot(s.normal, w);
      m[4] = dot(s.along, w);
      m[5] = dot(s.across, w);
    }
  }
  for (int j = 0; j < free; ++j) {
    const int u = ring.column[dofs[j]];
    Lane force[n];    // the ring's spin does not displace the surface of revolution
    local_forces(s, motions[j], dofs[j] != RingProgram::SPIN, force);
    Lane *B = system.B(group, u), *C = system.C(group, u);
    for (int k = 0; k < 6; ++k)
      for (int i = 0; i < n; ++i) {
        if ((i == 0 && k >= 3 && !depth) || (i >= 3 && k < 3)) continue;    // zero entries of the
                                                                            // rows
        B[k] -= row[i][k] * force[i];
      }
    for (int k = 0; k < 6; ++k)
      for (int i = 0; i < n; ++i) C[k] -= motions[j][i] * column[k][i];
    for (int o = 0; o < free; ++o) {
      Lane a = motions[o][0] * force[0];
      for (int i = 1; i < n; ++i) a += motions[o][i] * force[i];
      system.D(ring.column[dofs[o]], u) += sum(a);
    }
  }
}

// Computes positions and motions for a group of contacts that are all open.
static RACEWAY_INLINE void look_at_gap(const RacewayPhysics &p, const BallStateT<Lane> &ball,
                                       const LaneFrame &f, const Vec3 &ring_v, const Vec3 &ring_w,
                                       RingStateT<Lane> ring, const GroovePositionT<Lane> &at,
                                       const Lane &overlap, ContactStateT<Lane> &seen)
{
  ring.v = f.local(ring_v);
  ring.w = f.local(ring_w);
  static_cast<GroovePositionT<Lane> &>(seen) = at;
  seen.overlap = overlap;
  find_motions<false>(p, ball, ring, seen);
}

// Returns the elastic energy of contacts minus their energy at the same overlap but with the
// entrainment speeds and contact angles at the start of the step, J. No force does work when these
// change.
template <class L>
static RACEWAY_INLINE double energy_gain(const L &law, const RacewayPhysics &p,
                                         const LaneMask &near, const ContactStateT<Lane> &c,
                                         BearingBodies::BalancedContact &balanced)
{
  const BearingBodies::EnergyBasis &from = balanced.from;
  balanced.now = {where(near, c.entrainment, 0.0), where(near, c.cos_angle, -1.0)};
  LaneMask moved = c.cos_angle != from.cos_angle;
  if (law.decides) moved |= c.entrainment != from.entrainment;
  moved &= near & (from.cos_angle >= 0.0);
  if (!any(moved)) return 0.0;
  double gained = 0.0;
  for (const bool before : {false, true}) {
    ContactStateT<Lane> at = c;
    if (before) {
      at.entrainment = where(moved, from.entrainment, c.entrainment);
      at.cos_angle = where(moved, from.cos_angle, c.cos_angle);
    }
    const auto k = p.law.at(at.cos_angle);
    LaneMask live = moved;
    if (law.decides) {
      live &= ~law.misses(p, k, at);
      at.overlap = where(live, at.overlap, Lane(at.overlap - law.beyond(p, at) + barely_touching));
    }
    const Lane none[L::room] = {};
    Lane unused[L::room];
    law.act(p, k, LawStates<Lane>{0.0, none, unused}, at);
    const double energy = sum(where(live, law.energy(p, at), 0.0));
    gained += before ? -energy : energy;
  }
  return gained;
}

// Slopes are set and read in the same stages, which the compiler cannot infer.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
template <class L> RACEWAY_INLINE Failure BearingForces::raceways(const L &law, const Stage &stage)
{
  constexpr bool flawed = L::takes_profiles;
  int contact = 0;
  for (const BearingBodies::Track &track : b_.tracks) {
    RingBody &ring = b_.rings[track.ring];
    const RacewayPhysics &p = *track.physics;
    const Vec3 spin = ring.now.angular_velocity();
    // offset of the groove from the ring's mid-plane
    const double offset = p.groove.offset;
    Vec3 centre = ring.now.x - b_.centre, velocity = ring.now.v;
    if (offset != 0.0) {
      const Vec3 arm = ring.now.e * offset;
      centre += arm;
      velocity += cross(spin, arm);
    }
    for (int k = track.first; k < track.end; ++k, ++contact) {
      BodyGroup &g = b_.groups[k];
      const LaneFrame &f = g.now;
      const Vec3L at = f.local(centre);
      const Vec3L d = {f.r - at.x, -at.y, f.z - at.z};
      RingStateT<Lane> r;
      r.e = f.local(ring.now.e);
      ContactStateT<Lane> c;
      locate(d, r.e, p.centre_circle, c);
      auto apart = out_of_reach(p, c);
      const bool balls = flawed && !b_.ball_profiles.empty() && b_.ball_profiles[contact].any;
      const bool profiled = flawed && (track.profile || balls);
      TurnRowT<Lane> *depth = nullptr;    // row of the depth of the ball profiles
      if (balls) {
        look_at_profiles(track, b_.ball_profiles[contact], b_.turns[b_.turns_at[k]], f, ring.now,
                         r.e, c, on_, turned_);
        depth = &b_.ball_rows[contact];
        *depth = turn_row(turned_.along, turned_.across, r.e, c);
      } else if (flawed && track.profile) look_at_profile(track, f, ring.now, c, on_);
      if (profiled) {
        c.overlap = on_.overlap;
        apart = c.overlap <= -p.reach;
      }
      LaneMask live = g.used & ~apart;
      const bool derive = stage.evaluate == Evaluate::derivatives;
      LaneMask close = live;
      if (derive && !law.decides) close = g.used & ~(c.overlap <= -p.reach - stage.close);
      Lane unused[L::room];
      if (law.states > 0)
        if (stage.evaluate != Evaluate::only) {
          for (int m = 0; m < law.states; ++m)
            b_.kept[contact].now[m] = Lane{};    // the state of an open contact is reset
          KeptSlopes &slopes = b_.kept_slopes[contact];
          slopes.live = LaneMask{};
          if (derive)
            for (int m = 0; m < law.states; ++m) std::fill(slopes.of[m], slopes.of[m] + 6, Lane{});
        }
      if (stage.looks) {
        stage.looks[contact].live = live;
        stage.looks[contact].orbit = dot(g.v - f.local(ring.now.v), c.t) / c.r;
      }
      const Lane gap = -c.overlap;
      const auto look_at_gaps = [&] {
        if (stage.gaps)
          look_at_gap(p, {d, g.v, g.w}, f, velocity, spin, r, c, -gap, stage.looks[contact].state);
      };
      if (!any(close)) {
        look_at_gaps();
        continue;
      }
      if (any(live & ~(c.overlap < p.largest_overlap))) {
        for (int i = 0; i < lanes; ++i)
          if (live[i] && !(c.overlap[i] < p.largest_overlap)) body_ = b_.body_at[lanes * k + i];
        return Failure::outside_groove;
      }
      c.overlap = where(live, c.overlap, barely_touching);
      r.v = f.local(velocity);
      r.w = f.local(spin);
      const BallStateT<Lane> ball = {d, g.v, g.w};
      find_motions<L::couples>(p, ball, r, c);
      if constexpr (flawed)    // energy balances always use this loop
        if (stage.evaluate == Evaluate::only && !stage.looks && !b_.balanced.empty())
          energy_gained_ += energy_gain(law, p, live, c, b_.balanced[contact]);
      if (law.decides) {
        live &= ~law.misses(p, p.law.at(c.cos_angle), c);
        if (stage.looks) stage.looks[contact].live = live;
        const Lane beyond = law.beyond(p, c);
        close = derive ? close & ~(beyond <= -stage.close) : live;
        if (!any(close)) {
          look_at_gaps();
          continue;
        }
        c.overlap = where(live, c.overlap, Lane(c.overlap - beyond + barely_touching));
      }
      if (flawed && track.profile) c.overlap_rate -= on_.slope * passing_speed(ball, r, c);
      if (balls) c.overlap_rate -= depth->rate(ball, r, d);
      LawStates<Lane> memory;
      if (law.states > 0) {
        BearingBodies::States &kept = b_.kept[contact];
        memory = stage.evaluate == Evaluate::only
                     ? LawStates<Lane>{0.0, kept.now, unused}
                     : LawStates<Lane>{stage.h, kept.base, kept.now, !stage.dampers_only};
      }
      ContactSlopesT<Lane, L::motions> slopes;
      for (int m = 0; m < law.states; ++m)
        std::fill(slopes.state[m], slopes.state[m] + L::motions, Lane{});
      if (derive) act_with_slopes(law, p, memory, stage.follows(), c, slopes);
      else law.act(p, p.law.at(c.cos_angle), memory, c);
      if (law.states > 0)
        if (stage.evaluate != Evaluate::only) {
          for (int m = 0; m < law.states; ++m)
            b_.kept[contact].now[m] = where(live, b_.kept[contact].now[m], 0.0);
          b_.kept_slopes[contact].live = live;
        }
      ContactForcesT<Lane> q = assemble<L::couples>(p, r.e, c);
      if (flawed && track.profile) push_along(on_.slope, r.e, c, q);
      if (balls) push_along(*depth, d, c, q);
      if (offset != 0.0) from_groove(r.e, offset, q);
      for (Vec3L *v : {&q.force, &q.ball_torque, &q.ring_torque})
        *v = {where(live, v->x, 0.0), where(live, v->y, 0.0), where(live, v->z, 0.0)};
      ring.force_lanes -= f.lab(q.force);
      ring.moment_lanes += f.lab(q.ring_torque);
      if (stage.looks) {
        ContactStateT<Lane> &seen = stage.looks[contact].state;
        seen = c;
        if (stage.gaps) seen.overlap = where(live, c.overlap, -gap);
        seen.u = f.lab(c.u);
        seen.t = f.lab(c.t);
        continue;
      }
      if (stage.evaluate == Evaluate::only) {
        power_lost_ += sum(where(live, law.loss(c), 0.0));
        contact_energy_ += sum(where(live, law.energy(p, c), 0.0));
        if (profiled) contact_energy_ += sum(where(live, on_.energy, 0.0));
      }
      g.rhs[0] += stage.h * q.force.x;
      g.rhs[1] += stage.h * q.force.y;
      g.rhs[2] += stage.h * q.force.z;
      g.rhs[3] += stage.h * q.ball_torque.x;
      g.rhs[4] += stage.h * q.ball_torque.y;
      g.rhs[5] += stage.h * q.ball_torque.z;
      if (!derive) continue;
      const Lane stiffness = where(live, c.stiffness, 0.0);
      g.stiffness = where(stiffness > g.stiffness, stiffness, g.stiffness);
      if (stage.dampers_only) {
        g.spring += stiffness;
        g.damper += where(live, c.damping, 0.0);
        ring.spring += sum(stiffness);
      }
      if (profiled) slopes.of[0][0] += stage.follows() * c.stiffness * on_.follows;
      const auto s = scaled(stage.h, stage.follows(), c, r.e, close, slopes);
      const Vec3L from_ring = offset != 0.0 ? d + r.e * offset : d;
      add_matrix(system_, g, k, ring, p.groove.ball_radius, from_ring, r.e, s,
                 flawed && track.profile ? &on_ : nullptr, depth);
      if (flawed && track.profile) {
        const Lane h2 = where(live, all_lanes(stage.h * stage.follows()), 0.0);
        add_profile(system_, g, k, ring, from_ring, r.e, c, h2, on_);
      }
      if (balls) {
        const Lane h2 = where(live, all_lanes(stage.h * stage.follows()), 0.0);
        const Lane slope = track.profile ? on_.slope : Lane{};
        add_ball_profile(system_, g, k, ring, from_ring, r.e, c, h2, slope, *depth, turned_);
      }
      if (law.states > 0) {
        KeptSlopes &kept = b_.kept_slopes[contact];
        kept.stiffness = c.stiffness;
        kept.normal = s.normal;
        kept.along = s.along;
        kept.across = s.across;
        kept.lever = lever_of(ring, r.e, from_ring + s.normal * p.groove.ball_radius);
        if (flawed && track.profile) kept.slope = on_.slope;
        for (int m = 0; m < law.states; ++m)
          for (int i = 0; i < L::motions; ++i) kept.of[m][i] = where(live, slopes.state[m][i], 0.0);
      }
    }
  }
  return Failure::none;
}
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

}    // namespace raceway
