// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the energy of a bearing and its change over a step.
#include "bearing_integrator.h"

namespace raceway {

void BearingIntegrator::keep_energy(bool yes)
{
  keep_energy_ = yes;
  bodies_.balanced.assign(yes ? bodies_.n_contacts : 0, {});
}

// Adds the work done by loads and drives and the losses in the contacts. Each is the power at the
// end of a stage multiplied by the weight of the stage (s).
void BearingIntegrator::add_energy(const Stage &stage, double weight, double s)
{
  system_.start(stage.h, false);
  forces_.evaluate(stage);
  system_.add_border(stage.h, stage.follows(), s, false);
  double power = -power_of_residual(stage.h);
  // if only the dampers are implicit, free degrees of freedom move at the old velocity during half
  // of the step
  const double old_share = stage.dampers_only ? 0.5 : 0.0;
  double lost = forces_.power_lost();
  loads_.resize(bodies_.border.size());
  bodies_.border_loads(s, loads_);
  for (size_t k = 0; k < loads_.size(); ++k) {
    const Coordinate &c = bodies_.border[k];
    const double v = *c.now;
    power += loads_[k] * (v + (*c.from - v) * old_share);
    lost += c.damper * v * v;
  }
  for (const RingBody &r : bodies_.rings)
    if (!r.carried) power -= bodies_.power_on_drives(r);    // the drives of a carried ring act on
                                                            // its shaft
  if (bodies_.heavy) power += power_of_gravity(old_share);
  for (const RingBody &r : bodies_.rings)
    if (r.program.supported) {
      const RingPose seen = bodies_.held(r);
      lost += r.program.support_loss(seen, seen.rate[0], seen.rate[1]);
    }
  pending_.work += weight * power;
  pending_.dissipated += weight * lost;
  pending_.stored = forces_.energy_gained();    // value at the end of the last stage
}

// Returns the power (W) of the residual of the last correction in a stage of h seconds. Corrections
// stop once positions have converged. The friction at these velocities then differs from the
// friction that moved the bodies, and the drive must supply the power of the latter. The difference
// is a fraction of the losses, which are small compared with the power exchanged between the ring
// and the balls. The powers on the bodies and on the free degrees of freedom of the rings are equal
// except for the slip at contacts.
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

// Returns the power of gravity on the bodies, W, where the old velocities have the weight
// old_share.
double BearingIntegrator::power_of_gravity(double old_share) const
{
  Lane power = {};
  for (const BodyGroup &g : bodies_.groups)
    power +=
        where(g.used,
              g.mass * dot(g.v + (g.v_from - g.v) * old_share, g.now.local(bodies_.gravity)), 0.0);
  return sum(power);
}

const BearingIntegrator::Energy &BearingIntegrator::energy()
{
  energy_.stored = stored_energy();
  return energy_;
}

// Returns the energy in the current state, J, i.e. the kinetic energy of bodies and coordinates and
// the elastic energy of supports, modes and contacts.
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
  bodies_.on_border([](auto &one) { one.now = one.from; });
  for (const Coordinate &c : bodies_.border) {
    total += 0.5 * *c.mass * *c.now * *c.now;
    if (c.place) total += 0.5 * c.spring * *c.place * *c.place;
  }
  for (const RingBody &r : bodies_.rings)
    if (r.program.supported) total += r.program.support_energy(bodies_.held(r));
  forces_.evaluate(Stage());
  return total + forces_.contact_energy();
}

}    // namespace raceway
