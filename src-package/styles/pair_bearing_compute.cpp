// SPDX-License-Identifier: GPL-2.0-or-later
// The step: fill the contact table, add forces.
#include "pair_bearing_forces.h"

#include "../deck/arguments.h"
#include "../physics/damped_hertz.h"
#include "fix_bearing_state.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
using bearing::SphereContact;
using bearing::text;

void PairBearingHertz::compute(int eflag, int vflag)
{
  BRG_EV_INIT(eflag, vflag);
  state_->forward_axes();
  if (neighbor->ago == 0 || rebuild_) rebuild_contacts();
  ++fills_;
  if (smooth()) smooth_raceway_forces();
  else flawed_raceway_forces();
  sphere_forces(evflag);
  ring_sum_.flush();
}

void PairBearingHertz::smooth_raceway_forces()
{
  with_law(law_, [this](auto law) {
    using L = decltype(law);
    if constexpr (in_lanes<L>) forces_in_lanes<L>();
    else raceway_forces<L, false>();
  });
}

// Whether this step moves what the law keeps of a contact. The forces of a set-up belong to a step
// already made; fixes that advance it themselves are asked for by group.
bool PairBearingHertz::advances(const RacewayContact &c) const
{
  return !update->setupflag && !(atom->mask[c.i_ball] & implicit_bits_);
}

BallState PairBearingHertz::ball_of(const RacewayContact &c) const
{
  return {Vec3::from(atom->x[c.i_ball]), Vec3::from(atom->v[c.i_ball]),
          Vec3::from(atom->omega[c.i_ball])};
}

// The ring as its groove moves, which may lie beside the ring's middle plane.
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

void PairBearingHertz::put(const RacewayContact &c, const BallState &ball, const RingState &groove,
                           int lane, ContactLanes &to) const
{
  const auto set = [lane](Vec3T<Lane> &at, const Vec3 &value) {
    at.x[lane] = value.x;
    at.y[lane] = value.y;
    at.z[lane] = value.z;
  };
  set(to.ball.x, ball.x - groove.x);
  set(to.ball.v, ball.v);
  set(to.ball.w, ball.w);
  set(to.ring.v, groove.v);
  set(to.ring.w, groove.w);
  set(to.ring.e, groove.e);
  for (int k = 0; k < most_states; ++k) to.before[k][lane] = c.kept[k];
}

void PairBearingHertz::tally(const RacewayContact &c, const ContactForces &forces, double energy)
{
  const Vec3 d = Vec3::from(atom->x[c.i_ball]) - groove_of(c).x;
  // only this rank sees the pair: count it whole (newton = 1)
  ev_tally_xyz(c.i_ball, c.i_ring, atom->nlocal, 1, eflag_either ? energy : 0.0, 0.0,
               forces.force.x, forces.force.y, forces.force.z, d.x, d.y, d.z);
}

// As touch(), with what the profiles leave of the overlap.
bool PairBearingHertz::touch_profile(RacewayContact &c, const Vec3 &d, const Vec3 &e,
                                     ProfiledContact &on, BallSlopes &turned)
{
  ContactState &s = c.state;
  locate(d, e, c.raceway->centre_circle, s);
  s.overlap = s.s - c.raceway->slack;
  const LabAxes axes = {axis_};
  const Vec3 u = axes.third(s.u);
  BallView view;
  if (c.ball_profile) {
    const Quaternion to_ball = state_->turn(c.i_ball).back();
    view = {to_ball(axes.third(s.u * s.nu + e * s.ne)), to_ball(axes.third(s.t)),
            to_ball(axes.third(e * s.nu - s.u * s.ne))};
  }
  on = profiled(c.profile, c.ball_profile, *c.raceway,
                std::atan2(u.y, u.x) - state_->angle(c.i_ring), s.r, s.overlap, view, turned);
  s.overlap = on.overlap;
  return !(s.overlap <= -c.raceway->reach);
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
    s.loss = (h.force - h.stiffness * overlap / 1.5) * rate;
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
