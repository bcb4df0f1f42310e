// SPDX-License-Identifier: GPL-2.0-or-later
// Forces and their derivatives at the present place of one bearing, put into the block arrow system.
#include "implicit_bearing.h"

#include "fix_bearing_cage.h"
#include "pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using namespace raceway;

namespace bearing {

// Masses, and on the right what is still missing of M (V_n - V) + h frame.
void ImplicitBearing::start_system()
{
  system_.clear();
  for (int k = 0; k < body_count(); ++k) {
    const Body &b = bodies_[k];
    ArrowSystem::Block &s = system_.block[k];
    const double rate = b.v.y / b.now.r;
    const Vec3 dv = b.v_start - b.v + frame_acceleration(rate, b.v) * h_;
    system_.add_rhs(k, b.now.lab(dv) * b.mass);
    for (int m = 0; m < 3; ++m) s.A[7 * m] = b.mass;
    if (b.size == 3) continue;
    const Vec3 dw = b.w_start - b.w + frame_acceleration(rate, b.w) * h_;
    system_.add_rhs(k, b.now.lab(dw) * b.inertia, 3);
    for (int m = 3; m < 6; ++m) s.A[7 * m] = b.inertia;
  }
  for (Free &f : free_) f.unit = in(lab_unit(f.dof, rings_[f.ring]));
  for (Ring &r : rings_) r.force = r.moment = Vec3();
}

// Velocity of a ring's point at `lever` from its centre for a unit of this degree of freedom.
Vec3 ImplicitBearing::motion_of(const Free &f, const Vec3 &lever) const
{
  return f.dof < 3 ? f.unit : cross(f.unit, lever);
}

// Derivatives of a contact force between body and ring: the body's own block, and its coupling to what is free
// of the ring. reach: distance of the contact point along the normal from the body's centre if its spin counts.
void ImplicitBearing::couple(int k, int ring, const ContactJacobian &j, const Vec3 &lever, double reach)
{
  const Body &b = bodies_[k];
  double *A = system_.block[k].A;
  const Vec3 arm = j.normal * reach;
  const bool spins = b.size == 6;
  for (int m = 0; m < 3; ++m)
    for (int n = 0; n < 3; ++n) A[6 * m + n] += j.both.a[3 * m + n];
  if (spins) {
    const Mat3 spin = times_cross(j.damping, arm);         // D [arm]x: force from the body's spin, with - sign
    const Mat3 turn = cross_times(arm, j.both), both = cross_times(arm, spin);
    for (int m = 0; m < 3; ++m)
      for (int n = 0; n < 3; ++n) {
        A[6 * m + n + 3] -= spin.a[3 * m + n];
        A[6 * (m + 3) + n] += turn.a[3 * m + n];
        A[6 * (m + 3) + n + 3] -= both.a[3 * m + n];
      }
  }
  const Ring &r = rings_[ring];
  if (!r.loose) return;
  const int nf = static_cast<int>(free_.size());
  for (int p = 0; p < FixBearingRing::N_DOF; ++p) {
    const int f = r.unknown[p];
    if (f < 0) continue;
    system_.block[k].coupled = true;
    const Vec3 q = motion_of(free_[f], lever);
    const Mat3 &M = p == FixBearingRing::SPIN_DOF ? j.damping : j.both;
    const Vec3 push = M * q;                               // force on the body
    double *C = system_.row(k, f);
    system_.add_column(k, f, -push);
    const Vec3 back = q * j.both;
    (-back).add_to(C);
    if (spins) {
      system_.add_column(k, f, -cross(arm, push), 3);
      // q D (w x arm) = w . (arm x (q D))
      (-cross(arm, q * j.damping)).add_to(C + 3);
    }
    for (int o = 0; o < FixBearingRing::N_DOF; ++o)
      if (r.unknown[o] >= 0) system_.D[r.unknown[o] * nf + f] += dot(motion_of(free_[r.unknown[o]], lever), push);
  }
}

bool ImplicitBearing::choose_grooves()
{
  const Friction f = pair_->friction();
  if (pair_->lubricated())
    return f == Friction::none  ? add_grooves<true, Friction::none>()
        : f == Friction::constant ? add_grooves<true, Friction::constant>()
                                  : add_grooves<true, Friction::stribeck>();
  return f == Friction::none ? add_grooves<false, Friction::none>() : add_grooves<false, Friction::constant>();
}

template <bool film, Friction friction> bool ImplicitBearing::add_grooves()
{
  for (Groove &g : grooves_) {
    const Body &b = bodies_[g.body];
    Ring &r = rings_[g.ring];
    const RacewayPhysics &p = *g.physics;
    if (!touch(p, b.x_lab - r.now.x, r.now.e, g.state)) continue;
    if (!(g.state.overlap < p.largest_overlap)) return false;
    const BallState ball = {b.x_lab, b.v_lab, b.w_lab};
    const ContactForces f = contact_forces<film, friction>(p, ball, r.now, FrictionSmoothed(), g.state);
    system_.add_rhs(g.body, f.force * h_);
    system_.add_rhs(g.body, f.ball_torque * h_, 3);
    r.force -= f.force;
    r.moment += f.ring_torque;
    const ContactJacobian j = contact_jacobian(g.state, p.slack, r.now.e, h_, h_ * h_, true);
    couple(g.body, g.ring, j, b.x_lab - r.now.x + j.normal * b.radius, b.radius);
  }
  return true;
}

// Cage contacts are links of the system: their force on the right, their stiffness along the normal.
void ImplicitBearing::add_pockets()
{
  for (const PartModel::Pocket &s : pockets_) {
    const Vec3 d = bodies_[s.a].x_lab - bodies_[s.b].x_lab;
    const double r2 = dot(d, d);
    if (r2 >= s.reach * s.reach) continue;
    const double r = std::sqrt(r2);
    const Vec3 n = d * (1.0 / r), dv = bodies_[s.a].v_lab - bodies_[s.b].v_lab;
    const DampedHertz c = damped_hertz(s.K, s.reach - r, -dot(dv, n), s.mass);
    if (!(c.force > 0.0)) continue;
    const Vec3 push = n * (h_ * c.force);
    system_.add_rhs(s.a, push);
    system_.add_rhs(s.b, -push);
    if (!system_.link(s.a, s.b, n, h_ * c.damping + h_ * h_ * c.stiffness))
      BRG_ONE("fix bearing/implicit: atom " + std::to_string(bodies_[s.a].tag) + " or " +
              std::to_string(bodies_[s.b].tag) + " touches more than two balls or cage balls");
  }
}

void ImplicitBearing::add_seats()
{
  for (const PartModel::Seat &s : seats_) {
    const Body &b = bodies_[s.body];
    Ring &r = rings_[s.ring];
    const Vec3 d = b.x_lab - r.now.x, dv = b.v_lab - r.now.v - cross(r.now.w, d);
    for (size_t k = 0; k < s.cage->rails().size(); ++k) {
      RailTouch touch;
      if (!touch_rail(s.cage->rails()[k], s.cage->stiffness()[k], d, r.now.e, b.radius, b.mass, dv, touch)) continue;
      const Vec3 force = touch.n * touch.h.force;
      system_.add_rhs(s.body, force * h_);
      r.force -= force;
      r.moment -= cross(d, force);
      ContactJacobian j;
      j.normal = touch.n;
      if (r.loose) j.damping.add(h_ * touch.h.damping, touch.n, touch.n);
      j.both.add(h_ * touch.h.damping + h_ * h_ * touch.h.stiffness, touch.n, touch.n);
      couple(s.body, s.ring, j, d, 0.0);
    }
  }
}

}    // namespace bearing
