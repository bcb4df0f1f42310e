// SPDX-License-Identifier: GPL-2.0-or-later
// The step of the pair style: fills the contact table and adds the forces.
#include "pair_bearing_hertz.h"

#include "../core/laws/damped_hertz.h"
#include "../core/settings/arguments.h"

using namespace LAMMPS_NS;
using namespace raceway;
using bearing::RacewayContact;
using bearing::SphereContact;
using bearing::text;

// Overlap on the far side of a groove above which the run stops with an error, as a fraction of r_c
// - R_b. Before they have settled, balls may touch this side lightly.
static constexpr double far_touch = 1e-2;

void PairBearingHertz::compute(int eflag, int vflag)
{
  BRG_EV_INIT(eflag, vflag);
  state_->forward_axes();
  if (neighbor->ago == 0 || rebuild_) rebuild_contacts();
  ++fills_;
  const bool energies = evflag && eflag_either;
  evaluator_.evaluate(table_, {state_, &coefficients_.facts(), coefficients_.axis_index(),
                               implicit_bits_, gaps_, energies, profiles_.any()});
  for (size_t n = 0; n < table_.raceway.size(); ++n)
    if (table_.raceway[n].live)
      add_forces(table_.raceway[n], evaluator_.forces(n), evaluator_.energy(n));
  sphere_forces(evflag);
  ring_sum_.flush();
}

void PairBearingHertz::add_forces(const RacewayContact &c, const ContactForces &forces,
                                  double energy)
{
  if (!(c.state.overlap < c.raceway->largest_overlap) || !std::isfinite(c.state.normal)) lost(c);
  if (c.state.overlap > far_touch * c.raceway->slack &&
      (c.side() == Side::inner ? c.state.nu : -c.state.nu) > 0.0)
    far_side(c);
  forces.force.add_to(atom->f[c.i_ball]);
  forces.ball_torque.add_to(atom->torque[c.i_ball]);
  ring_sum_.add(c.claim, -forces.force, forces.ring_torque);
  if (evflag) tally(c, forces, energy);
}

void PairBearingHertz::tally(const RacewayContact &c, const ContactForces &forces, double energy)
{
  const Vec3 d = Vec3::from(atom->x[c.i_ball]) - evaluator_.groove_of(c).x;
  // the pair is computed only on this rank, so it counts in full (newton = 1)
  ev_tally_xyz(c.i_ball, c.i_ring, atom->nlocal, 1, eflag_either ? energy : 0.0, 0.0,
               forces.force.x, forces.force.y, forces.force.z, d.x, d.y, d.z);
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
    s.loss = damping_loss(h, overlap, rate);
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

// Returns "ball B on inner ring R at step S".
static std::string place_of(const RacewayContact &c, bigint step)
{
  return "ball " + std::to_string(c.ball) + " on " + (c.side() == Side::inner ? "inner" : "outer") +
         " ring " + std::to_string(c.ring) +
         (c.raceway->groove.offset != 0.0 ? " in groove " + std::to_string(c.groove()) : "") +
         " at step " + std::to_string(step);
}

// Stops with an error because a ball touches the far side of a groove. The torus of the groove
// extends beyond the shoulders, but a ring has no surface there.
void PairBearingHertz::far_side(const RacewayContact &c)
{
  BRG_ONE(place_of(c, update->ntimestep) + ": force " + text(c.state.normal) +
          " N on the far side of the groove, at a contact angle above 90 degrees. The free play is "
          "more than 2 (r_c - R_b) = " +
          text(2.0 * c.raceway->slack) + " m, or the load forces the ball over the shoulder");
  std::abort();
}

void PairBearingHertz::lost(const RacewayContact &c)
{
  BRG_ONE(place_of(c, update->ntimestep) + ": overlap " + text(c.state.overlap) + " m, force " +
          text(c.state.normal) + " N, largest allowed overlap " + text(c.raceway->largest_overlap) +
          " m (" + c.raceway->limit() + "). The step " + text(update->dt) +
          " s is too large, the load is too high, or bodies overlap at the start");
  std::abort();
}
