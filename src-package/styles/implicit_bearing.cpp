// SPDX-License-Identifier: GPL-2.0-or-later
#include "implicit_bearing.h"

#include "fix_bearing_cage.h"
#include "fix_bearing_ring.h"
#include "pair_bearing_hertz.h"

using namespace LAMMPS_NS;
using raceway::BearingModel;
using raceway::BodyPose;
using raceway::RingPose;

namespace bearing {

static BearingModel model_of(const PairBearingHertz &pair, const PartModel &part)
{
  BearingModel m;
  for (const PartModel::Body &b : part.bodies) m.bodies.push_back({b.mass, b.radius, b.spins});
  m.rings = static_cast<int>(part.rings.size());
  for (const PartModel::Groove &g : part.grooves) m.grooves.push_back({g.body, g.ring, g.physics});
  for (const PartModel::Pocket &p : part.pockets)
    m.pockets.push_back({p.a, p.b, p.K, p.reach, p.mass});
  for (const PartModel::Seat &s : part.seats)
    m.seats.push_back({s.body, s.ring, &s.cage->rails(), &s.cage->stiffness()});
  m.parts = pair.law();
  return m;
}

ImplicitBearing::ImplicitBearing(const PairBearingHertz &pair, const PartModel &part) :
    axis_(pair.axis_index()), step_(new raceway::BearingStep(model_of(pair, part))),
    bodies_(part.bodies.size()), rings_(part.rings.size())
{
  for (const PartModel::Body &b : part.bodies) tags_.push_back(b.tag);
  for (const PartModel::Ring &r : part.rings) {
    fixes_.push_back(r.fix);
    own_.push_back(r.own);
  }
}

void ImplicitBearing::load(const std::vector<BodyState> &bodies,
                           const std::vector<RingFullState> &rings)
{
  for (size_t k = 0; k < bodies.size(); ++k)
    bodies_[k] = {in(bodies[k].x), in(bodies[k].v), in(bodies[k].w)};
  for (size_t k = 0; k < rings.size(); ++k) {
    const RingFullState &r = rings[k];
    RingPose &p = rings_[k];
    p.x = in(r.x);
    p.v = in(r.v);
    p.e = in(r.motion.axis);
    p.origin = in(r.motion.origin);
    p.angle = r.motion.angle;
    for (int i = 0; i < 2; ++i) p.tilt[i] = r.motion.tilt[i];
    p.set_angular_velocity(in(r.w));
    if (fixes_[k]) step_->set_program(static_cast<int>(k), fixes_[k]->program(own_[k]));
  }
  step_->load(bodies_, rings_);
}

void ImplicitBearing::store(std::vector<BodyState> &bodies, std::vector<RingFullState> &rings) const
{
  step_->store(bodies_, rings_);
  for (size_t k = 0; k < bodies.size(); ++k)
    bodies[k] = {out(bodies_[k].x), out(bodies_[k].v), out(bodies_[k].w)};
  for (size_t k = 0; k < rings.size(); ++k) {
    const RingPose &p = rings_[k];
    RingFullState &r = rings[k];
    r.x = out(p.x);
    r.v = out(p.v);
    r.w = out(p.angular_velocity());
    r.motion.axis = out(p.e);
    r.motion.angle = p.angle;
    for (int i = 0; i < 2; ++i) r.motion.tilt[i] = p.tilt[i];
  }
}

}    // namespace bearing
