// SPDX-License-Identifier: GPL-2.0-or-later
// Forces of one bearing and their derivatives, four balls side by side, in each ball's own turning
// frame. A call with h = 0 evaluates only: loads of the rings, power lost in contacts and energy of
// their springs.
#include "bearing_step.h"

#include <algorithm>

namespace raceway {

// What is still missing of M (V_base - V) + h frame; masses into the blocks.
RACEWAY_LANES void BearingStep::start_rhs(double h, bool fresh)
{
  for (Group &g : groups_) {
    const Lane rate = g.v.y / g.now.r;
    const Vec3L dv = (g.v_base - g.v + frame_acceleration(rate, g.v) * h) * g.mass;
    dv.to(g.rhs);
    if (g.spins) {
      const Vec3L dw = (g.w_base - g.w + frame_acceleration(rate, g.w) * h) * g.inertia;
      dw.to(g.rhs + 3);
    }
    if (!fresh) continue;
    for (Lane &a : g.A) a = Lane{};
    for (int m = 0; m < 3; ++m) g.A[7 * m] = g.mass;
    for (int m = 3; m < 6; ++m) g.A[7 * m] = g.inertia;
    g.coupled = g.linked = false;
    g.spring = g.damper = Lane{};
  }
  if (!fresh) return;
  for (Ring &r : rings_) r.spring = 0.0;
  for (Column &c : B_) c = Column();
  for (Column &c : C_) c = Column();
  std::fill(border_.a.begin(), border_.a.end(), 0.0);
}

// += s p q^T into rows and columns of a 6 x 6 block
static RACEWAY_INLINE void add_dyad(Lane *a, const Lane &s, const Vec3L &p, const Vec3L &q)
{
  const Lane x = s * p.x, y = s * p.y, z = s * p.z;
  a[0] += x * q.x;
  a[1] += x * q.y;
  a[2] += x * q.z;
  a[6] += y * q.x;
  a[7] += y * q.y;
  a[8] += y * q.z;
  a[12] += z * q.x;
  a[13] += z * q.y;
  a[14] += z * q.z;
}

// Velocity of a ring's point at `lever` from its centre for a unit of a degree of freedom; e is the
// ring's axis.
static RACEWAY_INLINE Vec3L motion_of(int dof, const LaneFrame &f, const Vec3L &e,
                                      const Vec3L &lever)
{
  const Lane one = all_lanes(1.0), none = {};
  switch (dof) {
    case 0: return {f.c, -f.s, none};
    case 1: return {f.s, f.c, none};
    case 2: return {none, none, one};
    case 3: return cross(Vec3L{f.c, -f.s, none}, lever);
    case 4: return cross(Vec3L{f.s, f.c, none}, lever);
    default: return cross(e, lever);
  }
}

template <bool film, Friction friction>
RACEWAY_INLINE bool BearingStep::grooves(double h, bool fresh)
{
  Touch *touch = touches_.data();
  const int nf = static_cast<int>(free_.size());
  const double springs = dampers_only_ ? 0.0 : h * h;
  for (const Track &track : tracks_) {
    Ring &ring = rings_[track.ring];
    const RacewayPhysics &p = *track.physics;
    const Vec3 centre = ring.now.x - centre_, spin = ring.now.angular_velocity();
    const double R = p.groove.ball_radius;
    for (int k = track.first; k < track.end; ++k, ++touch) {
      Group &g = groups_[k];
      const LaneFrame &f = g.now;
      ContactStateT<Lane> &c = touch->state;
      const Vec3L at = f.local(centre);
      const Vec3L d = {f.r - at.x, -at.y, f.z - at.z};
      RingStateT<Lane> r;
      r.e = f.local(ring.now.e);
      locate(d, r.e, p.centre_circle, c);
      c.overlap = c.s - p.slack;
      const LaneMask live = touch->live =
          g.used & ~(c.overlap <= 0.0);    // what is not a number must not pass for a gap
      if (!any(live)) continue;
      if (any(live & ~(c.overlap < p.largest_overlap))) {
        for (int i = 0; i < lanes; ++i)
          if (live[i] && !(c.overlap[i] < p.largest_overlap)) worst_ = body_at_[lanes * k + i];
        return false;
      }
      c.overlap = where(live, c.overlap, 1e-9);
      r.v = f.local(ring.now.v);
      r.w = f.local(spin);
      const BallStateT<Lane> ball = {d, g.v, g.w};
      ContactForcesT<Lane> q = contact_forces<film, friction>(p, ball, r, FrictionSmoothed(), c);
      for (Vec3L *v : {&q.force, &q.ball_torque, &q.ring_torque})
        *v = {where(live, v->x, 0.0), where(live, v->y, 0.0), where(live, v->z, 0.0)};
      ring.force_lanes -= f.lab(q.force);
      ring.moment_lanes += f.lab(q.ring_torque);
      if (h == 0.0) {
        const Lane lost = (c.normal - c.load) * c.overlap_rate + c.friction_t * c.sliding_t +
                          c.friction_w * c.sliding_w;
        power_lost_ += sum(where(live, lost, 0.0));
        contact_energy_ += sum(where(live, 0.4 * c.load * c.overlap, 0.0));
        continue;
      }
      for (int m = 0; m < 3; ++m) {
        const Lane *force = m == 0 ? &q.force.x : m == 1 ? &q.force.y : &q.force.z;
        const Lane *torque = m == 0   ? &q.ball_torque.x
                             : m == 1 ? &q.ball_torque.y
                                      : &q.ball_torque.z;
        g.rhs[m] += h * *force;
        g.rhs[m + 3] += h * *torque;
      }
      if (!fresh) continue;
      const ContactJacobianT<Lane> j = contact_jacobian(c, r.e, live, h, springs);
      if (dampers_only_) {
        const Lane spring = where(live, c.stiffness, 0.0);
        g.spring += spring;
        g.damper += where(live, c.damping, 0.0);
        ring.spring += sum(spring);
      }
      const Vec3L pull = j.n + j.friction;
      add_dyad(g.A, j.push, pull, j.n);
      add_dyad(g.A, j.along, j.t, j.t);
      add_dyad(g.A, j.across, j.w, j.w);
      const Lane turning = j.grip * R;
      add_dyad(g.A + 3, turning, j.t, j.w);
      add_dyad(g.A + 3, -turning, j.w, j.t);
      const Vec3L twist = cross(j.n, j.friction);
      add_dyad(g.A + 18, j.push * R, twist, j.n);
      add_dyad(g.A + 18, j.along * R, j.w, j.t);
      add_dyad(g.A + 18, -j.across * R, j.t, j.w);
      add_dyad(g.A + 21, turning * R, j.w, j.w);
      add_dyad(g.A + 21, turning * R, j.t, j.t);
      if (!ring.loose) continue;
      g.coupled = true;
      const Vec3L lever = d + j.n * R;
      for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
        const int u = ring.unknown[dof];
        if (u < 0) continue;
        const Vec3L m = motion_of(dof, f, r.e, lever);
        const Vec3L push =
            dof == RingProgram::SPIN ? j.damped(m) : j.times(m);    // force on the ball
        const Vec3L torque = cross(j.n, push) * R, back = j.before(m), turn = j.turned(m) * R;
        Lane *B = B_[k * nf + u].a, *C = C_[k * nf + u].a;
        B[0] -= push.x;
        B[1] -= push.y;
        B[2] -= push.z;
        B[3] -= torque.x;
        B[4] -= torque.y;
        B[5] -= torque.z;
        C[0] -= back.x;
        C[1] -= back.y;
        C[2] -= back.z;
        C[3] -= turn.x;
        C[4] -= turn.y;
        C[5] -= turn.z;
        for (int o = 0; o < RingProgram::N_DOF; ++o)
          if (ring.unknown[o] >= 0)
            border_.a[ring.unknown[o] * nf + u] += sum(dot(motion_of(o, f, r.e, lever), push));
      }
    }
  }
  return true;
}

RACEWAY_LANES bool BearingStep::forces(double h, bool fresh)
{
  power_lost_ = contact_energy_ = 0.0;
  for (Ring &r : rings_) {
    r.force_lanes = r.moment_lanes = Vec3L();
    r.force = r.moment = Vec3();
  }
  bool sane = false;
  if (model_.lubricated) switch (model_.friction) {
      case Friction::none: sane = grooves<true, Friction::none>(h, fresh); break;
      case Friction::constant: sane = grooves<true, Friction::constant>(h, fresh); break;
      case Friction::stribeck: sane = grooves<true, Friction::stribeck>(h, fresh); break;
    }
  else if (model_.friction == Friction::none) sane = grooves<false, Friction::none>(h, fresh);
  else sane = grooves<false, Friction::constant>(h, fresh);
  if (!sane) return false;
  seats(h, fresh);
  if (!pockets(h, fresh)) return false;
  for (Ring &r : rings_) {
    r.force = {sum(r.force_lanes.x), sum(r.force_lanes.y), sum(r.force_lanes.z)};
    r.moment = {sum(r.moment_lanes.x), sum(r.moment_lanes.y), sum(r.moment_lanes.z)};
  }
  return true;
}

// Cage balls on the torus rails of a ring: elastic, frictionless, critically damped.
RACEWAY_LANES void BearingStep::seats(double h, bool fresh)
{
  const int nf = static_cast<int>(free_.size());
  const double springs = dampers_only_ ? 0.0 : h * h;
  for (const RailTrack &track : rail_tracks_) {
    Ring &ring = rings_[track.ring];
    const Vec3 centre = ring.now.x - centre_, spin = ring.now.angular_velocity();
    for (int k = track.first; k < track.end; ++k) {
      Group &g = groups_[k];
      const LaneFrame &f = g.now;
      const Vec3L at = f.local(centre), e = f.local(ring.now.e);
      const Vec3L d = {f.r - at.x, -at.y, f.z - at.z};
      const Lane z = dot(d, e);
      const Vec3L radial = d - e * z;
      const Lane r = norm(radial);
      const Vec3L u = radial * (1.0 / r), dv = g.v - f.local(ring.now.v) - cross(f.local(spin), d);
      for (size_t rail = 0; rail < track.rails->size(); ++rail) {
        const double K = (*track.stiffness)[rail];
        const RailContactT<Lane> c =
            rail_contact((*track.rails)[rail], K, r, z, dot(dv, u), dot(dv, e), g.radius, g.mass);
        const LaneMask live = g.used & ~(c.h.force <= 0.0);
        if (!any(live)) continue;
        const Vec3L n = u * c.nr + e * c.ne;
        const Vec3L force = n * where(live, c.h.force, 0.0);
        ring.force_lanes -= f.lab(force);
        ring.moment_lanes -= f.lab(cross(d, force));
        if (h == 0.0) {
          const Lane overlap = 4.0 / 9.0 * c.h.stiffness * c.h.stiffness / (K * K);
          const Lane spring = c.h.stiffness / 1.5 * overlap, rate = -dot(dv, n);
          power_lost_ += sum(where(live, (c.h.force - spring) * rate, 0.0));
          contact_energy_ += sum(where(live, 0.4 * spring * overlap, 0.0));
          continue;
        }
        g.rhs[0] += h * force.x;
        g.rhs[1] += h * force.y;
        g.rhs[2] += h * force.z;
        if (!fresh) continue;
        const Lane a = where(live, h * c.h.damping + springs * c.h.stiffness, 0.0);
        if (dampers_only_) {
          g.spring += where(live, c.h.stiffness, 0.0);
          g.damper += where(live, c.h.damping, 0.0);
        }
        const Lane a_spin = where(live, h * c.h.damping, 0.0);
        add_dyad(g.A, a, n, n);
        if (!ring.loose) continue;
        g.coupled = true;
        for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
          const int j = ring.unknown[dof];
          if (j < 0) continue;
          const Lane m = dot(motion_of(dof, f, e, d), n);
          const Vec3L push = n * ((dof == RingProgram::SPIN ? a_spin : a) * m), back = n * (a * m);
          Lane *B = B_[k * nf + j].a, *C = C_[k * nf + j].a;
          B[0] -= push.x;
          B[1] -= push.y;
          B[2] -= push.z;
          C[0] -= back.x;
          C[1] -= back.y;
          C[2] -= back.z;
          for (int o = 0; o < RingProgram::N_DOF; ++o)
            if (ring.unknown[o] >= 0)
              border_.a[ring.unknown[o] * nf + j] += sum(dot(motion_of(o, f, e, d), push));
        }
      }
    }
  }
}

// Balls and cage balls: each closed contact is a link. False if another set is closed than at the
// last factorisation.
bool BearingStep::pockets(double h, bool fresh)
{
  if (model_.pockets.empty()) return true;
  for (size_t k = 0; k < groups_.size(); ++k) {
    if (!in_pocket_[k]) continue;
    const Group &g = groups_[k];
    const Vec3L x = g.now.place(), v = g.now.lab(g.v);
    for (int i = 0; i < lanes; ++i)
      place_[lanes * k + i] = {{x.x[i], x.y[i], x.z[i]}, {v.x[i], v.y[i], v.z[i]}};
  }
  if (fresh) chain_.clear();
  touching_.clear();
  for (size_t i = 0; i < model_.pockets.size(); ++i) {
    const BearingModel::Pocket &p = model_.pockets[i];
    const int a = slot_[p.a], b = slot_[p.b];
    const Vec3 d = Vec3::from(place_[a].x) - Vec3::from(place_[b].x);
    const double r2 = dot(d, d);
    if (r2 >= p.reach * p.reach) continue;
    const double r = std::sqrt(r2), overlap = p.reach - r;
    const Vec3 n = d * (1.0 / r), dv = Vec3::from(place_[a].v) - Vec3::from(place_[b].v);
    const double rate = -dot(dv, n);
    const DampedHertz c = damped_hertz(p.K, overlap, rate, p.mass);
    if (!(c.force > 0.0)) continue;
    if (h == 0.0) {
      const double spring = c.stiffness / 1.5 * overlap;
      power_lost_ += (c.force - spring) * rate;
      contact_energy_ += 0.4 * spring * overlap;
      continue;
    }
    touching_.push_back(static_cast<int>(i));
    Vec3 local[2];
    for (int k = 0; k < 2; ++k) {
      const int slot = k == 0 ? a : b, lane = slot % lanes;
      Group &g = groups_[slot / lanes];
      const double cosine = g.now.c[lane], sine = g.now.s[lane];
      local[k] = {n.x * cosine + n.y * sine, n.y * cosine - n.x * sine, n.z};
      const double push = k == 0 ? h * c.force : -h * c.force;
      g.rhs[0][lane] += push * local[k].x;
      g.rhs[1][lane] += push * local[k].y;
      g.rhs[2][lane] += push * local[k].z;
      if (fresh) {
        g.linked = true;
        g.spring[lane] += c.stiffness;
        g.damper[lane] += c.damping;
      }
    }
    if (fresh && !chain_.add(a, b, local[0], local[1],
                             h * c.damping + (dampers_only_ ? 0.0 : h * h) * c.stiffness)) {
      overlinked_ = p.a;
      return false;
    }
  }
  if (h == 0.0) return true;
  if (fresh) touched_ = touching_;
  return touching_ == touched_;
}

}    // namespace raceway
