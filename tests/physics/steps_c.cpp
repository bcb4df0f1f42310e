// SPDX-License-Identifier: GPL-2.0-or-later
// Exports implicit steps of one or two bodies to test_physics_steps.py.
#include "../../src-package/core/interface/exports.h"
#include "small_bearings.h"

#include <algorithm>

using namespace raceway;

RECORD(RingEnd, double e[3], rate[2], x[3], v[3];)

// Computes the state after n steps of a single ring that is free except for its driven spin, under
// a constant force and moment. If order is 0, only dampers are implicit.
EXPORT(void, lone_ring,
       (int order, int n, double h, double spin, const double inertia[2], const double moment[3],
        RingEnd *out))
{
  LoneRing alone;
  auto &[m, p, bodies, rings] = alone;
  BearingIntegrator step(m);
  for (Freedom &f : p.mode) f = Freedom::free;
  p.mode[RingProgram::SPIN] = Freedom::speed;
  p.inertia = {inertia[0], inertia[1]};
  p.target[0][RingProgram::SPIN] = p.target[1][RingProgram::SPIN] = spin;
  p.moment[0] = p.moment[1] = Vec3::from(moment);
  p.force[0] = p.force[1] = {1.0, 2.0, 3.0};
  step.set_program(0, p);
  rings[0].spin = spin;
  step.load(bodies, rings);
  BearingIntegrator::Settings set;
  set.order = order;
  set.dampers_only = order == 0;
  set.newton = 1e-15;
  set.corrections = 30;
  for (int k = 0; k < n; ++k) {
    step.step(set, h, 0.0, 1.0);
    step.accept();
  }
  step.store(bodies, rings);
  rings[0].e.to(out->e);
  out->rate[0] = rings[0].rate[0];
  out->rate[1] = rings[0].rate[1];
  rings[0].x.to(out->x);
  rings[0].v.to(out->v);
}

// Simulates a single ring of 0.5 kg that is free along z, on a spring (stiffness 0: no spring),
// under a constant force. It moves from place[0] (m) and velocity[0] (m/s) to place[1] and
// velocity[1] in n steps of h seconds, with a relative tolerance. Returns the largest error (m)
// estimated in a step.
EXPORT(double, estimated_errors,
       (double relative, int n, double h, double stiffness, double force, double place[2],
        double velocity[2]))
{
  LoneRing alone;
  auto &[m, p, bodies, rings] = alone;
  BearingIntegrator step(m);
  p.mode[2] = Freedom::free;
  p.force[0] = p.force[1] = {0.0, 0.0, force};
  p.support[2].stiffness = stiffness;
  p.supported = stiffness > 0.0;
  step.set_program(0, p);
  rings[0].x.z = place[0];
  rings[0].v.z = velocity[0];
  step.load(bodies, rings);
  BearingIntegrator::Settings set;
  set.estimate = true;
  set.newton = 1e-18;
  set.relative = relative;
  double largest = 0.0;
  for (int k = 0; k < n; ++k) {
    largest = std::max(largest, step.step(set, h, 0.0, 1.0).error);
    step.accept();
  }
  step.store(bodies, rings);
  place[1] = rings[0].x.z;
  velocity[1] = rings[0].v.z;
  return largest;
}

// Simulates a ball that rolls around an outer raceway in steps of h seconds. Only inertia presses
// it on the raceway, from which it is initially `gap` (m) away. Returns the number of corrections
// and the estimated error of each step, and the overlap after the step. If `heavy` (m) is above 0,
// a second ball with this overlap also rolls around.
EXPORT(void, resting,
       (double speed, double gap, double heavy, double newton, double h, int n, double *corrections,
        double *error, double *overlap))
{
  RacewayPhysics outer = dry_outer();
  BearingModel model;
  model.bodies = {{1, 8.17e-3, 6.3e-3, true}};
  model.rings = {{2, 0, {}}};
  model.grooves = {{0, 0, &outer}};
  model.parts = outer.parts;
  std::vector<BodyPose> bodies = {{{30.3e-3 - gap, 0.0, 0.0}, {0.0, speed, 0.0}, Vec3(), {}}};
  if (heavy > 0.0) {
    model.bodies.push_back({3, 8.17e-3, 6.3e-3, true});
    model.grooves.push_back({1, 0, &outer});
    bodies.push_back({{-30.3e-3 - heavy, 0.0, 0.0}, Vec3(), Vec3(), {}});
  }
  BearingIntegrator step(model);
  std::vector<RingPose> rings(1);
  step.load(bodies, rings);
  BearingIntegrator::Settings set;
  set.newton = newton;
  set.corrections = 30;
  for (int k = 0; k < n; ++k) {
    const BearingIntegrator::Outcome o = step.step(set, h, 0.0, 1.0);
    corrections[k] = o.solved() ? o.corrections : HUGE_VAL;
    error[k] = o.error;
    step.accept();
    step.store(bodies, rings);
    overlap[k] = std::hypot(bodies[0].x.x, bodies[0].x.y) - 30.3e-3;
  }
}

// Computes the number of corrections in a step of h seconds in which a ball approaches the cage
// ball ahead of it; HUGE_VAL if there is no solution.
EXPORT(double, meeting, (double gap, double speed, double h, double newton))
{
  BearingModel model;
  model.bodies = {{1, 8.17e-3, 6.3e-3, true}, {2, 3.5e-4, 4.19e-3, false}};
  model.rings = {{3, 0, {}}};
  const double reach = 6.3e-3 + 4.19e-3;
  model.pockets = {{0, 1, 1.3e9, reach, 3.4e-4}};
  const double angle = 2.0 * std::asin(0.5 * (reach + gap) / 30.3e-3), c = std::cos(angle),
               s = std::sin(angle);
  BearingIntegrator step(model);
  const double r = 30.3e-3;
  step.load(
      {{{r, 0.0, 0.0}, {0.0, speed, 0.0}, Vec3(), {}}, {{r * c, r * s, 0.0}, Vec3(), Vec3(), {}}},
      std::vector<RingPose>(1));
  BearingIntegrator::Settings set;
  set.newton = newton;
  const BearingIntegrator::Outcome o = step.step(set, h, 0.0, 1.0);
  return o.solved() ? o.corrections : HUGE_VAL;
}
