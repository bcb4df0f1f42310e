// SPDX-License-Identifier: GPL-2.0-or-later
// State and motion of one bearing under an implicit step; its forces are in implicit_forces.cpp.
#include "implicit_bearing.h"

#include "fix_bearing_cage.h"
#include "fix_bearing_state.h"
#include "pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using raceway::TurningFrame;
using raceway::Vec3;

namespace bearing {

ImplicitBearing::ImplicitBearing(LAMMPS *lmp, PairBearingHertz *pair, const PartModel &model) :
    Pointers(lmp), pair_(pair), axis_(pair->axis_index()), pockets_(model.pockets), seats_(model.seats)
{
  for (const PartModel::Body &m : model.bodies) {
    Body b = Body();
    b.tag = m.tag;
    b.size = m.spins ? 6 : 3;
    b.mass = m.mass;
    b.radius = m.radius;
    b.inertia = 0.4 * b.mass * b.radius * b.radius;
    bodies_.push_back(b);
  }
  for (const PartModel::Ring &r : model.rings) add_ring(r.fix);
  for (const PartModel::Groove &g : model.grooves)
    grooves_.push_back({g.body, g.ring, g.physics, raceway::ContactState()});
  system_.resize(body_count(), static_cast<int>(free_.size()));
  for (int k = 0; k < body_count(); ++k) system_.block[k].size = bodies_[k].size;
  gained_.assign(free_.size(), 0.0);
}

void ImplicitBearing::add_ring(FixBearingRing *fix)
{
  Ring r = Ring();
  r.fix = fix;
  for (int k = 0; k < FixBearingRing::N_DOF; ++k) {
    r.unknown[k] = -1;
    if (!fix || fix->mode(k) != FixBearingRing::free) continue;
    r.unknown[k] = static_cast<int>(free_.size());
    r.loose = true;
    const double inertia = k < 3                ? fix->mass()
        : k == FixBearingRing::SPIN_DOF ? fix->inertia().axial
                                        : fix->inertia().transverse;
    free_.push_back({static_cast<int>(rings_.size()), k, inertia, Vec3()});
  }
  rings_.push_back(r);
}

void ImplicitBearing::load(const std::vector<BodyState> &bodies, const std::vector<RingFullState> &rings)
{
  for (size_t k = 0; k < rings_.size(); ++k) {
    Ring &r = rings_[k];
    r.x_start = rings[k].x;
    r.v_start = rings[k].v;
    r.w_start = rings[k].w;
    r.motion_start = rings[k].motion;
  }
  // balls circle the ring that is not free, the last one if there is a choice
  centre_ = in(rings_.front().x_start);
  for (const Ring &r : rings_)
    if (!r.fix || (r.unknown[0] < 0 && r.unknown[1] < 0 && r.unknown[2] < 0)) centre_ = in(r.x_start);
  for (size_t k = 0; k < bodies_.size(); ++k) {
    Body &b = bodies_[k];
    b.start = TurningFrame::at(in(bodies[k].x) - centre_);
    b.v_start = b.start.local(in(bodies[k].v));
    b.w_start = b.start.local(in(bodies[k].w));
  }
}

void ImplicitBearing::store(std::vector<BodyState> &bodies, std::vector<RingFullState> &rings) const
{
  for (size_t k = 0; k < rings_.size(); ++k) {
    const Ring &r = rings_[k];
    rings[k] = {r.x_start, r.v_start, r.w_start, r.motion_start};
  }
  for (size_t k = 0; k < bodies_.size(); ++k) {
    const Body &b = bodies_[k];
    bodies[k].x = out(b.start.place() + centre_);
    bodies[k].v = out(b.start.lab(b.v_start));
    if (b.size == 6) bodies[k].w = out(b.start.lab(b.w_start));
  }
}

void ImplicitBearing::predict(double h, double s)
{
  h_ = h;
  share_ = s;
  for (Body &b : bodies_) {
    b.v = b.v_start;
    b.w = b.w_start;
  }
  std::fill(gained_.begin(), gained_.end(), 0.0);
  move();
}

void ImplicitBearing::move()
{
  for (Body &b : bodies_) {
    b.now = b.start.drifted(b.v, h_);
    b.x_lab = b.now.place() + centre_;
    b.v_lab = b.now.lab(b.v);
    b.w_lab = b.now.lab(b.w);
  }
  for (Ring &r : rings_) move_ring(r);
}

// Unit vector of a degree of freedom in lab names; spin about the axis at the start of the step.
Vec3 ImplicitBearing::lab_unit(int dof, const Ring &r) const
{
  if (dof == FixBearingRing::SPIN_DOF) return r.motion_start.axis;
  const int k = dof < 3 ? dof : (axis_ + dof - 2) % 3;
  return {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
}

void ImplicitBearing::move_ring(Ring &r)
{
  r.x_lab = r.x_start;
  r.v_lab = r.v_start;
  r.w_lab = r.w_start;
  r.motion = r.motion_start;
  if (r.fix) {
    for (int k = 0; k < FixBearingRing::N_DOF; ++k)
      if (r.unknown[k] >= 0) (k < 3 ? r.v_lab : r.w_lab) += lab_unit(k, r) * gained_[r.unknown[k]];
    double target[FixBearingRing::N_DOF], x[3], v[3], origin[3];
    for (int k = 0; k < FixBearingRing::N_DOF; ++k) target[k] = r.fix->target(k, share_);
    r.x_lab.to(x);
    r.v_lab.to(v);
    r.motion.origin.to(origin);
    for (int k = 0; k < 3; ++k) {
      const int mode = r.fix->mode(k);
      if (mode == FixBearingRing::fixed) v[k] = 0.0;
      if (mode == FixBearingRing::speed) v[k] = target[k];
      if (mode == FixBearingRing::position) v[k] = (origin[k] + target[k] - x[k]) / h_;
      x[k] += h_ * v[k];
    }
    r.x_lab = Vec3::from(x);
    r.v_lab = Vec3::from(v);
    r.fix->turn(r.motion, r.w_lab, h_, target);
  }
  r.now.x = in(r.x_lab);
  r.now.v = in(r.v_lab);
  r.now.w = in(r.w_lab);
  r.now.e = in(r.motion.axis);
}

// One Newton correction from the present velocities.
ImplicitBearing::Correction ImplicitBearing::correct()
{
  Correction c;
  start_system();
  if (!choose_grooves()) return c;
  add_pockets();
  add_seats();
  for (size_t f = 0; f < free_.size(); ++f) {
    const Free &q = free_[f];
    const Ring &r = rings_[q.ring];
    const Vec3 push = q.dof < 3 ? r.force + in(r.fix->load(share_)) : r.moment + in(r.fix->moment(share_));
    system_.D[f * free_.size() + f] += q.inertia;
    system_.y[f] = h_ * dot(push, q.unit) - q.inertia * gained_[f];
  }
  system_.solve();

  double largest = 0.0;
  for (int k = 0; k < body_count(); ++k) {
    Body &b = bodies_[k];
    const Vec3 dv = b.now.local(system_.solution(k));
    b.v += dv;
    if (b.size == 3) continue;
    b.w += b.now.local(system_.solution(k, 3));
    largest = std::fmax(largest, std::fmax(std::fabs(dv.x), std::fabs(dv.z)));
    if (!(std::fabs(dv.x) + std::fabs(dv.y) + std::fabs(dv.z) < HUGE_VAL)) return c;
  }
  for (size_t f = 0; f < free_.size(); ++f) {
    gained_[f] += system_.y[f];
    if (!(std::fabs(system_.y[f]) < HUGE_VAL)) return c;
    if (free_[f].dof == FixBearingRing::SPIN_DOF) continue;
    const double lever = free_[f].dof < 3 ? 1.0 : bodies_.front().now.r;
    largest = std::fmax(largest, std::fabs(system_.y[f]) * lever);
  }
  c.size = h_ * largest;
  c.sane = true;
  move();
  return c;
}

void ImplicitBearing::accept()
{
  for (Body &b : bodies_) {
    b.start = b.now;
    b.v_start = b.v;
    b.w_start = b.w;
  }
  for (Ring &r : rings_) {
    r.x_start = r.x_lab;
    r.v_start = r.v_lab;
    r.w_start = r.w_lab;
    r.motion_start = r.motion;
  }
}

}    // namespace bearing
