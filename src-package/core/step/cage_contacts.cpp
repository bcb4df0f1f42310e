// SPDX-License-Identifier: GPL-2.0-or-later
// Forces on cage balls at their rails, and contacts of balls with cage balls or with one another.
#include "bearing_forces.h"
#include "bearing_system.h"

#include "../bodies/ring_motions.h"

namespace raceway {

BearingForces::BearingForces(BearingBodies &bodies, BearingSystem &system) :
    b_(bodies), system_(system), place_(bodies.body_at.size()), in_pocket_(bodies.groups.size())
{
  for (const BearingModel::Pocket &p : b_.model.pockets)
    for (int k : {p.a, p.b}) in_pocket_[b_.slot[k] / lanes] = true;
}

Failure BearingForces::evaluate(const Stage &stage)
{
  power_lost_ = contact_energy_ = energy_gained_ = 0.0;
  body_ = -1;
  Failure failure = Failure::none;
  if (stage.kept) {
    system_.restore();
  } else {
    for (RingBody &r : b_.rings) r.force_lanes = r.moment_lanes = Vec3L();
    failure = all_raceways(stage);
    if (failure != Failure::none) return failure;
    if (stage.keep) system_.keep(stage.evaluate == Evaluate::derivatives);
  }
  for (RingBody &r : b_.rings) r.force = r.moment = Vec3();
  rails(stage);
  failure = pockets(stage);
  if (failure != Failure::none) return failure;
  for (RingBody &r : b_.rings) {
    r.force = {sum(r.force_lanes.x), sum(r.force_lanes.y), sum(r.force_lanes.z)};
    r.moment = {sum(r.moment_lanes.x), sum(r.moment_lanes.y), sum(r.moment_lanes.z)};
  }
  cages(stage);
  b_.add_shafts();
  return failure;
}

// Adds s p q^T to the rows and columns of a 6 x 6 block.
static RACEWAY_INLINE void add_dyad(Lane *a, const Lane &s, const Vec3L &p, const Vec3L &q)
{
  const Lane rows[] = {s * p.x, s * p.y, s * p.z}, columns[] = {q.x, q.y, q.z};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) a[6 * i + k] += rows[i] * columns[k];
}

// Evaluates contacts between cage balls and the torus-shaped rails of a ring. They are elastic,
// frictionless and critically damped.
RACEWAY_LANES void BearingForces::rails(const Stage &stage)
{
  const bool only = stage.evaluate == Evaluate::only;
  const bool fresh = stage.evaluate == Evaluate::derivatives;
  const double h = stage.h;
  const double springs = h * stage.follows();
  const double margin = fresh ? stage.close_cage : 0.0;
  for (const BearingBodies::RailTrack &track : b_.rail_tracks) {
    RingBody &ring = b_.rings[track.ring];
    const Vec3 centre = ring.now.x - b_.centre, spin = ring.now.angular_velocity();
    for (int k = track.first; k < track.end; ++k) {
      BodyGroup &g = b_.groups[k];
      const LaneFrame &f = g.now;
      const Vec3L at = f.local(centre), e = f.local(ring.now.e);
      const Vec3L d = {f.r - at.x, -at.y, f.z - at.z};
      const Lane z = dot(d, e);
      const Vec3L radial = d - e * z;
      const Lane r = norm(radial);
      // groups without a contact need no further work
      LaneMask near = {};
      for (const Rail &rail : *track.rails) near |= may_touch(rail, r, z, g.radius, margin);
      if (!any(near & g.used)) continue;
      const Vec3L u = radial * (1.0 / r), dv = g.v - f.local(ring.now.v) - cross(f.local(spin), d);
      for (size_t rail = 0; rail < track.rails->size(); ++rail) {
        const double K = (*track.stiffness)[rail];
        RailContactT<Lane> c =
            rail_contact((*track.rails)[rail], K, r, z, dot(dv, u), dot(dv, e), g.radius, g.mass);
        if (only) {
          const LaneMask touches = g.used & (c.overlap > 0.0);
          const Lane rate = -(dot(dv, u) * c.nr + dot(dv, e) * c.ne);
          power_lost_ += sum(where(touches, damping_loss(c.h, c.overlap, rate), 0.0));
          contact_energy_ +=
              sum(where(touches, 0.4 / 1.5 * c.h.stiffness * c.overlap * c.overlap, 0.0));
        }
        const LaneMask live = g.used & ~(c.h.force <= 0.0);
        LaneMask close = live;
        if (fresh) close |= g.used & (c.overlap <= 0.0) & (c.overlap > -stage.close_cage);
        if (!any(close)) continue;
        const Vec3L n = u * c.nr + e * c.ne;
        const Vec3L force = n * where(live, c.h.force, 0.0);
        ring.force_lanes -= f.lab(force);
        ring.moment_lanes -= f.lab(cross(d, force));
        g.rhs[0] += h * force.x;
        g.rhs[1] += h * force.y;
        g.rhs[2] += h * force.z;
        if (!fresh) continue;
        if (any(close & ~live)) {
          const auto barely = damped_hertz(K, all_lanes(barely_touching), Lane{}, g.mass);
          c.h.growth = where(live, c.h.growth, barely.growth);
          c.h.damping = where(live, c.h.damping, barely.damping);
        }
        const Lane a = where(close, h * c.h.damping + springs * c.h.growth, 0.0);
        if (stage.dampers_only) {
          g.spring += where(live, c.h.stiffness, 0.0);
          g.damper += where(live, c.h.damping, 0.0);
        }
        const Lane a_spin = where(close, h * c.h.damping, 0.0);
        add_dyad(g.A, a, n, n);
        if (!ring.loose) continue;
        g.coupled = true;
        const Vec3L lever = lever_of(ring, e, d);
        for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
          const int j = ring.column[dof];
          if (j < 0) continue;
          const Lane m = dot(motion_of(dof, f, e, lever), n);
          const Vec3L push = n * ((dof == RingProgram::SPIN ? a_spin : a) * m), back = n * (a * m);
          Lane *B = system_.B(k, j), *C = system_.C(k, j);
          B[0] -= push.x;
          B[1] -= push.y;
          B[2] -= push.z;
          C[0] -= back.x;
          C[1] -= back.y;
          C[2] -= back.z;
          for (int o = 0; o < RingProgram::N_DOF; ++o)
            if (ring.column[o] >= 0)
              system_.D(ring.column[o], j) += sum(dot(motion_of(o, f, e, lever), push));
        }
      }
    }
  }
}

// Evaluates contacts between balls and cage balls; each closed contact is a link.
Failure BearingForces::pockets(const Stage &stage)
{
  if (b_.model.pockets.empty() || stage.looks) return Failure::none;    // no force on rings
  const bool only = stage.evaluate == Evaluate::only;
  const bool fresh = stage.evaluate == Evaluate::derivatives;
  const double h = stage.h;
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    if (!in_pocket_[k]) continue;
    const BodyGroup &g = b_.groups[k];
    const Vec3L x = g.now.place(), v = g.now.lab(g.v);
    for (int i = 0; i < lanes; ++i)
      place_[lanes * k + i] = {{x.x[i], x.y[i], x.z[i]}, {v.x[i], v.y[i], v.z[i]}};
  }
  if (fresh) system_.links().clear();
  touching_.clear();
  for (size_t i = 0; i < b_.model.pockets.size(); ++i) {
    const BearingModel::Pocket &p = b_.model.pockets[i];
    const int a = b_.slot[p.a], b = b_.slot[p.b];
    const Vec3 d = Vec3::from(place_[a].x) - Vec3::from(place_[b].x);
    const double r2 = dot(d, d);
    if (r2 >= p.reach * p.reach) continue;
    const double r = std::sqrt(r2), overlap = p.reach - r;
    const Vec3 n = d * (1.0 / r), dv = Vec3::from(place_[a].v) - Vec3::from(place_[b].v);
    const double rate = -dot(dv, n);
    const DampedHertz c = damped_hertz(p.K, overlap, rate, p.mass);
    if (only) {
      power_lost_ += damping_loss(c, overlap, rate);
      contact_energy_ += 0.4 / 1.5 * c.stiffness * overlap * overlap;
    }
    if (!(c.force > 0.0)) continue;
    if (!only) touching_.push_back(static_cast<int>(i));
    Vec3 local[2];
    for (int k = 0; k < 2; ++k) {
      const int slot = k == 0 ? a : b, lane = slot % lanes;
      BodyGroup &g = b_.groups[slot / lanes];
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
    const double stiffness = h * c.damping + h * stage.follows() * c.growth;
    if (fresh && !system_.links().add(a, b, local[0], local[1], stiffness)) {
      body_ = p.a;
      return Failure::overlinked;
    }
  }
  if (only) return Failure::none;
  if (fresh) touched_ = touching_;
  return touching_ == touched_ ? Failure::none : Failure::other_links;
}

}    // namespace raceway
