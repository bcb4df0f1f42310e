// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the parts of a law that cause rolling friction to test_physics_rolling_friction.py. Tests
// specify a contact by its motions.
#include "../../src-package/core/interface/exports.h"
#include "any_parts.h"

using namespace raceway;

// A contact specified by its motions, and its results under the laws of the models `full`.
RECORD(Rolled, double side, overlap, overlap_rate, cos_angle, entrainment, sliding_t, sliding_w,
       spin_n, roll_w, dt, least, mu, mu_boundary, mu_film, beta, starvation, alpha, density, oil,
       eyring, limit;)
RECORD(Resisted, double load, normal, mu, lambda_, asperity_share, kt, a, b, friction_t, friction_w,
       couple_n, couple_w, slip_couple, rolling_couple, hysteresis_couple, drag, drag_power,
       friction_power, loss, states[2], slips[2];)

static Resisted resisted(const Rolled &in, unsigned parts, const double *before)
{
  RacewayPhysics p;
  const bool inner = in.side == 0.0;
  p.groove = {inner ? Side::inner : Side::outer, inner ? 24e-3 : 36.6e-3, 6.552e-3, 6.3e-3};
  p.model.lubricant = {0.04, 22e-9};
  p.ring_roughness = 1e-7;
  p.parts = parts;
  p.of<ConstantFrictionPart>().mu = in.mu;
  p.of<DifferentialSlipPart>().least = p.of<SlipSlicesPart>().least = in.least;
  p.of<MixedFrictionPart>().mu_boundary = in.mu_boundary;
  p.of<MixedFrictionPart>().mu_film = in.mu_film;
  p.of<MixedFrictionPart>().traction.stress = in.eyring;
  p.of<MixedFrictionPart>().traction.limit = in.limit;
  p.of<HydrodynamicRollingPart>().beta = in.beta;
  p.of<HydrodynamicRollingPart>().conductivity = 0.134;
  p.of<HydrodynamicRollingPart>().starvation = in.starvation;
  p.of<RollingHysteresisPart>().alpha = in.alpha;
  p.of<DragPart>().density = in.density;
  p.of<DragPart>().share = in.oil;
  p.prepare(30.3e-3, 8.17e-3, 0.05);
  ContactState c;
  c.overlap = in.overlap;
  c.overlap_rate = in.overlap_rate;
  c.cos_angle = in.cos_angle;
  c.entrainment = in.entrainment;
  c.sliding_t = in.sliding_t;
  c.sliding_w = in.sliding_w;
  c.spin_n = in.spin_n;
  c.roll_w = in.roll_w;
  Resisted out = {};
  double after[4] = {};
  with_parts(parts, [&](const auto &law) {
    const RacewayConstants k = p.law.at(c.cos_angle);
    law.act(p, k, LawStates<double>{in.dt, before, after}, c);
    out.loss = law.loss(c);
    out.a = k.a * c.root;
    out.b = k.b * c.root;
  });
  for (int k = 0; k < 2; ++k) {
    out.states[k] = after[k];
    out.slips[k] = after[2 + k];
  }
  out.load = c.load;
  out.normal = c.normal;
  out.mu = c.mu;
  out.lambda_ = c.lambda;
  out.asperity_share = c.asperity_share;
  out.kt = c.kt;
  out.friction_t = c.friction_t;
  out.friction_w = c.friction_w;
  out.couple_n = c.couple_n;
  out.couple_w = c.couple_w;
  out.slip_couple = c.slip_couple;
  out.rolling_couple = c.rolling_couple;
  out.hysteresis_couple = c.hysteresis_couple;
  out.drag = c.drag;
  out.drag_power = c.drag_power;
  out.friction_power = FrictionLoss::of(c);
  return out;
}

EXPORT(void, slip_of, (const Rolled *in, const double before[2], Resisted *out))
{
  using L = DryLaw<ConstantFrictionPart, DifferentialSlipPart>;
  *out = resisted(*in, L::parts, before);
}
EXPORT(void, dry_of, (const Rolled *in, const double before[2], Resisted *out))
{
  using L = DryLaw<ConstantFrictionPart, DifferentialSlipPart, RollingHysteresisPart, SpinPart>;
  *out = resisted(*in, L::parts, before);
}
EXPORT(void, slices_of, (const Rolled *in, const double before[4], Resisted *out))
{
  using L = DryLaw<ConstantFrictionPart, SlipSlicesPart, RollingHysteresisPart>;
  *out = resisted(*in, L::parts, before);
}
EXPORT(void, all_of, (const Rolled *in, const double before[2], Resisted *out))
{
  using L = LubricatedLaw<MixedFrictionPart, DifferentialSlipPart, HydrodynamicRollingPart,
                          RollingHysteresisPart, SpinPart, DragPart>;
  *out = resisted(*in, L::parts, before);
}
