// SPDX-License-Identifier: GPL-2.0-or-later
// Energy of a bearing and its change over a step.
#include "bearing_integrator.h"

namespace raceway {

void BearingIntegrator::keep_energy(bool yes)
{
  keep_energy_ = yes;
  const LawFacts facts = law_facts(bodies_.model.parts);
  bodies_.entrained.assign(yes && facts.decides ? bodies_.n_contacts : 0, {});
}

// Adds the work of loads and drives and the losses of the contacts at the end of a stage, times its
// weight in seconds.
void BearingIntegrator::add_energy(const Stage &stage, double weight, double s)
{
  system_.start(stage.h, false);
  forces_.evaluate(stage);
  system_.add_border(stage.h, stage.follows(), s, false);
  double power = -power_of_residual(stage.h);
  // if only dampers are implicit, free degrees of freedom move half the way at the old velocity
  const double old_share = stage.dampers_only ? 0.5 : 0.0;
  for (const RingBody &r : bodies_.rings) {
    if (r.carried) continue;    // its forces act on the shaft
    double push[3], pull[3], v[3], way[3];
    r.program.force_at(s, r.now.angle).to(push);
    Vec3 met_force = r.force, met_moment = r.moment;
    if (r.holds) bodies_.add_held(r, &met_force, &met_moment);
    met_force.to(pull);
    r.now.v.to(v);
    (r.now.v + (r.from.v - r.now.v) * old_share).to(way);
    for (int k = 0; k < 3; ++k) power += r.program.free(k) ? push[k] * way[k] : -pull[k] * v[k];
    const Vec3 load = r.program.moment_at(s, r.now), W = r.now.across(),
               before = r.from.across() - W;
    const double w[3] = {W.x, W.y, r.now.spin};
    const double turn[3] = {W.x + before.x * old_share, W.y + before.y * old_share,
                            r.now.spin + (r.from.spin - r.now.spin) * old_share};
    const double given[3] = {load.x, load.y, dot(load, r.now.e)};
    const double met[3] = {met_moment.x, met_moment.y, dot(met_moment, r.now.e)};
    for (int k = 0; k < 3; ++k)
      power += r.program.free(RingProgram::TILT + k) ? given[k] * turn[k] : -met[k] * w[k];
  }
  double lost = forces_.power_lost();
  for (ShaftBend &b : bodies_.bends) {
    const RingBody &shaft = bodies_.rings[b.shaft];
    const std::vector<double> &loads = b.loads(shaft.program, shaft.now, s);
    for (int k = 0; k < b.size(); ++k) {
      const double v = b.now.rate[k];
      power += loads[k] * (v + (b.from.rate[k] - v) * old_share);
      lost += b.modes->damping[k % b.modes->size()] * v * v;
    }
  }
  if (bodies_.heavy) power += power_of_gravity(old_share);
  for (const RingBody &r : bodies_.rings)
    if (r.program.supported) {
      const RingPose seen = bodies_.held(r);
      lost += r.program.support_loss(seen, seen.rate[0], seen.rate[1]);
    }
  pending_.work += weight * power;
  pending_.dissipated += weight * lost;
  pending_.stored = forces_.film_work();    // of the last stage
}

// Power of the residual of the last correction of a stage of h seconds, W. Corrections end once
// positions have converged. Friction at these velocities then differs from the friction that moved
// the bodies, and the drive must supply the latter. The difference is a share of the losses, which
// are small compared with the power exchanged between ring and balls. Bodies and free degrees of
// freedom of the rings have the same power except for the slip at contacts.
double BearingIntegrator::power_of_residual(double h) const
{
  Lane of_bodies = {};
  for (const BodyGroup &g : bodies_.groups) {
    Lane p = dot(Vec3L::from(g.rhs), g.v);
    if (g.spins) p += dot(Vec3L::from(g.rhs + 3), g.w);
    of_bodies += where(g.used, p, 0.0);
  }
  double power = sum(of_bodies);
  for (size_t k = 0; k < bodies_.border.size(); ++k) power += system_.y(k) * *bodies_.border[k].now;
  return power / h;
}

// Power of gravity on bodies and free degrees of freedom of the rings, W, with old_share of the old
// velocities.
double BearingIntegrator::power_of_gravity(double old_share) const
{
  const double fall[] = {bodies_.gravity.x, bodies_.gravity.y, bodies_.gravity.z};
  Lane of_bodies = {};
  for (const BodyGroup &g : bodies_.groups)
    of_bodies +=
        where(g.used,
              g.mass * dot(g.v + (g.v_from - g.v) * old_share, g.now.local(bodies_.gravity)), 0.0);
  double power = sum(of_bodies);
  for (const RingBody &r : bodies_.rings) {
    double v[3];
    (r.now.v + (r.from.v - r.now.v) * old_share).to(v);
    for (int k = 0; k < 3; ++k)
      if (r.program.free(k)) power += r.program.mass * fall[k] * v[k];
  }
  return power;
}

const BearingIntegrator::Energy &BearingIntegrator::energy()
{
  energy_.stored = stored_energy();
  return energy_;
}

// At the present state, J: kinetic energy of bodies and free degrees of freedom of the rings, and
// elastic energy of the contacts.
double BearingIntegrator::stored_energy()
{
  Lane motion = {};
  for (BodyGroup &g : bodies_.groups) {
    g.now = g.from;
    g.v = g.v_from;
    g.w = g.w_from;
    Lane e = 0.5 * g.mass * dot(g.v, g.v);
    if (g.spins) e += 0.5 * g.inertia * dot(g.w, g.w);
    motion += where(g.used, e, 0.0);
  }
  for (BallTurns &t : bodies_.turns) t.rest();
  double total = sum(motion);
  for (RingBody &r : bodies_.rings) r.now = r.from;
  for (ShaftBend &b : bodies_.bends) b.now = b.from;
  for (const RingBody &r : bodies_.rings) {
    double v[3];
    r.now.v.to(v);
    for (int k = 0; k < 3; ++k)
      if (r.program.free(k)) total += 0.5 * r.program.mass * v[k] * v[k];
    for (int k = 0; k < 2; ++k)
      if (r.program.free(RingProgram::TILT + k))
        total += 0.5 * r.program.inertia.transverse * r.now.rate[k] * r.now.rate[k];
    if (r.program.supported) total += r.program.support_energy(bodies_.held(r));
    if (r.program.free(RingProgram::SPIN))
      total += 0.5 * r.program.inertia.axial * r.now.spin * r.now.spin;
  }
  for (const ShaftBend &b : bodies_.bends) {
    total += strain_energy(*b.modes, b.now);
    for (int k = 0; k < b.size(); ++k)
      total += 0.5 * b.modes->mass[k % b.modes->size()] * b.now.rate[k] * b.now.rate[k];
  }
  forces_.evaluate(Stage());
  return total + forces_.contact_energy();
}

}    // namespace raceway
