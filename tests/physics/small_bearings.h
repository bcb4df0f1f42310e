// SPDX-License-Identifier: GPL-2.0-or-later
// Bearings of one or two bodies for the tests of the implicit step.
#pragma once
#include "../../src-package/core/contact/contact.h"
#include "../../src-package/core/step/bearing_integrator.h"

namespace raceway {

inline RacewayPhysics outer_6208(double mu)
{
  RacewayPhysics p;
  p.groove = {Side::outer, 36.6e-3, 6.552e-3, 6.3e-3};
  p.model.lubricant = {0.04, 22e-9};
  p.ring_roughness = 1e-7;
  p.parts = initial_parts(true);
  p.choose<ConstantFrictionPart>();
  p.choose<SmoothedFrictionPart>();
  p.of<ConstantFrictionPart>().mu = mu;
  p.prepare(30.3e-3, 8.17e-3, 0.05);
  return p;
}

// A 6208 outer raceway without lubricant or damping.
inline RacewayPhysics dry_outer()
{
  RacewayPhysics outer = outer_6208(0.0);
  outer.parts = initial_parts(false);
  outer.of<HysteresisPart>().alpha_e = 0.0;
  return outer;
}

// A ring that is alone except for a ball that it does not touch.
struct LoneRing {
  BearingModel model;
  RingProgram program;
  std::vector<BodyPose> bodies = {{{30e-3, 0, 0}, Vec3(), Vec3(), {}}};
  std::vector<RingPose> rings = std::vector<RingPose>(1);

  LoneRing()
  {
    model.bodies.push_back({1, 1.0, 5e-3, true});
    model.rings.push_back({2, 0, {}});
    program.mass = 0.5;
  }
};

}    // namespace raceway
