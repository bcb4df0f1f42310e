// SPDX-License-Identifier: GPL-2.0-or-later
// The energy of a bearing and what a step does to it.
#include "bearing_step.h"

namespace raceway {

// What loads and drives put in and contacts took out at the end of a stage, times its weight in
// seconds.
void BearingStep::add_energy(double weight, double s)
{
  forces_.evaluate(Stage());
  double power = 0.0;
  for (const RingBody &r : bodies_.rings) {
    if (r.carried) continue;    // the shaft has its forces
    double push[3], pull[3], v[3];
    r.program.force_at(s, r.now.angle).to(push);
    Vec3 met_force = r.force, met_moment = r.moment;
    if (r.holds) bodies_.add_held(r, &met_force, &met_moment);
    met_force.to(pull);
    r.now.v.to(v);
    for (int k = 0; k < 3; ++k) power += v[k] * (r.program.free(k) ? push[k] : -pull[k]);
    const Vec3 load = r.program.moment_at(s, r.now), W = r.now.across();
    const double w[3] = {W.x, W.y, r.now.spin};
    const double given[3] = {load.x, load.y, dot(load, r.now.e)};
    const double met[3] = {met_moment.x, met_moment.y, dot(met_moment, r.now.e)};
    for (int k = 0; k < 3; ++k)
      power += w[k] * (r.program.free(RingProgram::TILT + k) ? given[k] : -met[k]);
  }
  double lost = forces_.power_lost();
  for (ShaftBend &b : bodies_.bends) {
    const RingBody &shaft = bodies_.rings[b.shaft];
    const std::vector<double> &loads = b.loads(shaft.program, shaft.now, s);
    for (int k = 0; k < b.size(); ++k) {
      const double v = b.now.rate[k];
      power += loads[k] * v;
      lost += b.modes->damping[k % b.modes->size()] * v * v;
    }
  }
  if (bodies_.heavy) power += power_of_gravity();
  for (const RingBody &r : bodies_.rings)
    if (r.program.supported) {
      const RingPose seen = bodies_.held(r);
      lost += r.program.support_loss(seen, seen.rate[0], seen.rate[1]);
    }
  pending_.work += weight * power;
  pending_.dissipated += weight * lost;
}

// W, on bodies and on what is free of the rings.
double BearingStep::power_of_gravity() const
{
  const double fall[] = {bodies_.gravity.x, bodies_.gravity.y, bodies_.gravity.z};
  Lane of_bodies = {};
  for (const BodyGroup &g : bodies_.groups)
    of_bodies += where(g.used, g.mass * dot(g.v, g.now.local(bodies_.gravity)), 0.0);
  double power = sum(of_bodies);
  for (const RingBody &r : bodies_.rings) {
    double v[3];
    r.now.v.to(v);
    for (int k = 0; k < 3; ++k)
      if (r.program.free(k)) power += r.program.mass * fall[k] * v[k];
  }
  return power;
}

const BearingStep::Energy &BearingStep::energy()
{
  energy_.stored = stored_energy();
  return energy_;
}

// At the present state: motion of bodies and of what is free of the rings, and the springs of the
// contacts.
double BearingStep::stored_energy()
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
  for (RingBody &r : bodies_.rings) {
    r.now = r.from;
    double v[3];
    r.now.v.to(v);
    for (int k = 0; k < 3; ++k)
      if (r.program.free(k)) total += 0.5 * r.program.mass * v[k] * v[k];
    for (int k = 0; k < 2; ++k)
      if (r.program.free(RingProgram::TILT + k))
        total += 0.5 * r.program.inertia.transverse * r.now.rate[k] * r.now.rate[k];
    if (r.program.supported)
      total += r.program.support_energy(
          r.holder < 0 ? r.now : seen_from(r.from, bodies_.rings[r.holder].from));
    if (r.program.free(RingProgram::SPIN))
      total += 0.5 * r.program.inertia.axial * r.now.spin * r.now.spin;
  }
  for (ShaftBend &b : bodies_.bends) {
    b.now = b.from;
    total += strain_energy(*b.modes, b.now);
    for (int k = 0; k < b.size(); ++k)
      total += 0.5 * b.modes->mass[k % b.modes->size()] * b.now.rate[k] * b.now.rate[k];
  }
  forces_.evaluate(Stage());
  return total + forces_.contact_energy();
}

}    // namespace raceway
