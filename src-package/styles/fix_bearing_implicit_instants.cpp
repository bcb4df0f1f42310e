// SPDX-License-Identifier: GPL-2.0-or-later
// Handles requests for the state of the bearings at instants within host steps, and provides these
// states.
#include "fix_bearing_implicit_solver.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "ring_values.h"

#include <algorithm>

using namespace LAMMPS_NS;
using bearing::Instants;
using bearing::tag_t;
using raceway::BearingModel;

static std::string different(const FixBearingImplicit &fix)
{
  return std::string(": two fixes request different data between the steps of fix ") + fix.id +
         " bearing/implicit; use the same permittivity, film_floor, permittivity_at, surroundings, "
         "shoulders and roughness for all balls of a bearing";
}

// All requests must specify the same instants, which are evaluated only once. The capacitors of
// different bearings may differ.
void FixBearingImplicit::want_instants(const Instants &i, const std::string &command)
{
  const bool others = instants_.number > 1;
  if (others && i.number != instants_.number)
    BRG_ALL(command + ": 'within " + std::to_string(i.number) +
            "', but another fix requests 'within " + std::to_string(instants_.number) +
            "' of fix " + id + " bearing/implicit");
  for (const Capacitors &other : capacitors_)
    if (i.capacitor.permittivity > 0.0 && other.model != i.capacitor &&
        std::any_of(i.balls.begin(), i.balls.end(),
                    [&other](tag_t ball) { return other.balls.has(ball); }))
      BRG_ALL(command + different(*this));
  if (i.capacitor.permittivity > 0.0)
    capacitors_.push_back({i.capacitor, bearing::TagSet(i.balls)});
  instants_.number = i.number;
  instants_.states = instants_.states || i.states;
}

// Returns the capacitors that have been requested for the balls on each ring of the bearings that
// are solved as one.
std::vector<raceway::CapacitorModel> FixBearingImplicit::capacitors_of(const BearingModel &of) const
{
  std::vector<raceway::CapacitorModel> found(of.rings.size());
  for (const Capacitors &one : capacitors_)
    for (const BearingModel::Groove &g : of.grooves) {
      if (!one.balls.has(of.bodies[g.body].tag)) continue;
      raceway::CapacitorModel &own = found[g.ring];
      if (own.permittivity > 0.0 && own != one.model)
        BRG_ONE(bearing::name_of(*this) + different(*this));
      own = one.model;
    }
  return found;
}

// The solver's third axis is the bearing axis; contacts are read in the lab frame.
void FixBearingImplicit::turn_instants(int p)
{
  if (!instants_.states) return;
  const raceway::LabAxes axes = {pair_->coefficients().axis_index()};
  for (raceway::BearingAtInstant &instant : solver_->instants[p])
    for (raceway::BearingAtInstant::Contact &c : instant.contacts)
      if (c.live) {
        c.state.u = axes.lab(c.state.u);
        c.state.t = axes.lab(c.state.t);
      }
}

void FixBearingImplicit::read_instant(int k, const bearing::InstantReader &tell) const
{
  const raceway::LabAxes axes = {pair_->coefficients().axis_index()};
  for (int p = 0; p < static_cast<int>(solver_->own.size()); ++p) {
    const BearingModel &m = solver_->bearings.model(p);
    const raceway::BearingAtInstant &of = solver_->instants[p][k - 1];
    for (size_t g = 0; g < m.grooves.size(); ++g) {
      const BearingModel::Groove &groove = m.grooves[g];
      const raceway::BearingAtInstant::Contact &c = of.contacts[g];
      tell.contact({static_cast<tag_t>(m.bodies[groove.body].tag),
                    static_cast<tag_t>(m.rings[groove.ring].tag), *groove.physics, c.orbit, c.live,
                    c.load, c.capacitor, c.state});
    }
    if (tell.body)
      for (size_t b = 0; b < m.bodies.size(); ++b) {
        const raceway::BearingAtInstant::Body &now = of.bodies[b];
        // the spin of a cage ball does not change in the step
        const raceway::Vec3 &w = m.bodies[b].spins ? now.w : solver_->bearings.bodies(p)[b].w;
        tell.body(
            {static_cast<tag_t>(m.bodies[b].tag), axes.lab(now.x), axes.lab(now.v), axes.lab(w)});
      }
    if (tell.ring)
      for (size_t r = 0; r < m.rings.size(); ++r) {
        const raceway::BearingAtInstant::Ring &now = of.rings[r];
        bearing::InstantRing ring;
        bearing::ring_values({static_cast<double>(m.rings[r].tag), now.pose, now.pose.spin,
                              now.force, now.moment, now.acceleration},
                             axes, ring.of);
        tell.ring(ring);
      }
  }
}
