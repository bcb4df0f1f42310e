// SPDX-License-Identifier: GPL-2.0-or-later
// Samples of fix bearing/record. At the end of a step, each rank samples the atoms that it owns; at
// instants within a step, it samples the bearings whose home it is.
#include "contact_context.h"
#include "fix_bearing_cage.h"
#include "fix_bearing_capacitance.h"
#include "fix_bearing_implicit.h"
#include "fix_bearing_record.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "ring_values.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::RacewayContact;
using raceway::Vec3;
namespace of_ring = bearing::of_ring;

// Finds the integrators that provide samples within steps, and the balls for which they also
// provide the capacitance.
void FixBearingRecord::find_integrators()
{
  integrators_ = bearing::fixes_of<FixBearingImplicit>(lmp);
  for (int i = 0; i < atom->nlocal; ++i)
    if (rows_.ball(atom->tag[i]) >= 0 &&
        std::none_of(integrators_.begin(), integrators_.end(),
                     [&](const Fix *f) { return atom->mask[i] & f->groupbit; }))
      BRG_ONE(command_ + ": 'within " + std::to_string(within_) +
              "' needs fix bearing/implicit, which provides the states within a step; it does not "
              "move ball " +
              std::to_string(atom->tag[i]) + ". With other integrators sample every step");
  const std::vector<FixBearingCapacitance *> fixes = bearing::capacitances_of(lmp);
  std::vector<bearing::tag_t> balls;
  for (const FixBearingCapacitance *c : fixes)
    for (bearing::tag_t ball : c->find_members()) balls.push_back(ball);
  capacitors_ = bearing::TagSet(balls);
  for (FixBearingImplicit *f : integrators_) {
    f->want_instants({within_, {}, true, {}}, command_);
    for (const FixBearingCapacitance *c : fixes) f->want_instants(c->instants(within_), command_);
  }
}

void FixBearingRecord::sample(bool between)
{
  const double step = static_cast<double>(update->ntimestep);
  if (step == last_step_) return;
  check_time_step();
  if (between && within_ > 1) {
    if (sampled_) sample_instants();
    samples_ += within_ - 1;
  }
  if (sampled_) {
    sample_contacts();
    sample_cage();
    sample_parts();
    end_sample(step);
  }
  last_step_ = step;
  samples_ += 1.0;
}

// Samples the bearings whose home is on this rank at the instants within the step.
void FixBearingRecord::sample_instants()
{
  bearing::InstantReader tell;
  tell.contact = [this](const bearing::InstantContact &c) {
    const int ball = rows_.ball(c.ball);
    if (ball < 0) return;
    if (rows_.needs_orbit(ball, c.raceway.groove.side)) rows_.orbit(ball, c.orbit);
    if (!c.live && !context_.surroundings) return;
    const bool capacitor = capacitors_.has(c.ball);
    const bearing::ContactView view = {
        double(c.ball), double(c.ring),
        c.raceway,      c.state,
        context_.axis,  capacitor ? c.capacitor : raceway::FilmCapacitorT<double>{}};
    if (c.live) rows_.contact(ball, view);
    else sample_gap(ball, view);
  };
  tell.body = [this](const bearing::InstantBody &b) {
    const int ball = rows_.ball(b.tag);
    if (ball >= 0) rows_.cage(ball, NAN, NAN);    // known only at the ends of steps
    rows_.body(b.tag, b.x, b.v, b.w);
  };
  tell.ring = [this](const bearing::InstantRing &r) { rows_.ring(r.of); };
  for (int k = 1; k < within_; ++k) {
    for (const FixBearingImplicit *f : integrators_) f->read_instant(k, tell);
    end_sample(static_cast<double>(update->ntimestep) - double(within_ - k) / within_);
  }
}

// Samples the contacts of the balls of this rank.
void FixBearingRecord::sample_contacts()
{
  bearing::send_velocities(lmp);
  for (const RacewayContact &c : pair_->table().raceway) {
    const int ball = rows_.ball(c.ball);
    if (ball < 0) continue;
    if (rows_.needs_orbit(ball, c.side())) rows_.orbit(ball, bearing::orbit_of(*atom, *pair_, c));
    if (c.live) rows_.contact(ball, context_.view(c));
    else if (context_.surroundings) sample_gap(ball, context_.view(c));
  }
}

// Samples an open contact of a ball if a fix computes the capacitance of its surroundings.
void FixBearingRecord::sample_gap(int ball, const bearing::ContactView &view)
{
  if (view.capacitor.separation > 0.0) rows_.gap(ball, view);
}

// A ball is assigned half of the loss in its contacts with other balls, and all of the loss in its
// contacts with cage balls.
void FixBearingRecord::sample_cage()
{
  for (const bearing::SphereContact &s : pair_->table().sphere) {
    const int i = rows_.ball(s.tag_i), j = rows_.ball(s.tag_j);
    const double share = i >= 0 && j >= 0 ? 0.5 * s.loss : s.loss;
    if (i >= 0 && s.i < atom->nlocal) rows_.cage(i, share, s.force);
    if (j >= 0 && s.j < atom->nlocal) rows_.cage(j, share, s.force);
  }
  for (const bearing::PocketRow &p : pair_->table().pocket)
    if (p.ball == 0) rows_.land(p.cage, p.loss);
    else if (const int i = rows_.ball(p.ball); i >= 0) rows_.cage(i, p.loss, p.force);
  for (const FixBearingCage *f : cages_)
    for (const bearing::CageRails::CageBall &b : f->rails().balls) rows_.rail(b.tag, b.loss);
}

// Samples the balls, cage balls and rings of this rank.
void FixBearingRecord::sample_parts()
{
  for (int i = 0; i < atom->nlocal; ++i)
    rows_.body(atom->tag[i], Vec3::from(atom->x[i]), Vec3::from(atom->v[i]),
               Vec3::from(atom->omega[i]));
  double of[of_ring::N];
  for (int n = 0; n < pair_->ring_sum().rings(); ++n) {
    bearing::ring_values(*atom, *pair_, n, of);
    rows_.ring(of);
  }
}
