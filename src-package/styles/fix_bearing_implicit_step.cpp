// SPDX-License-Identifier: GPL-2.0-or-later
// Performs the steps of fix bearing/implicit: finds the bearings after a neighbour build, loads
// their state, performs the substeps and returns the state.
#include "../core/bodies/alike_bearings.h"
#include "../core/settings/arguments.h"
#include "find_record_layout.h"
#include "fix_bearing_implicit_solver.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_shaft.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>
#include <map>
#include <tuple>

using namespace LAMMPS_NS;
using bearing::tag_t;
using bearing::text;
using raceway::BearingIntegrator;
using raceway::BearingModel;

void FixBearingImplicit::build()
{
  if (build_ == pair_->table_build() && !laws_changed_) return;
  build_ = pair_->table_build();
  Solver &all = *solver_;
  // totals of the bearings at the last neighbour build
  for (const auto &integrator : all.integrators) {
    all.energy.work += integrator->spent().work;
    all.energy.dissipated += integrator->spent().dissipated;
  }
  bearing::BearingSources sources = bearing::sources_of(lmp, *pair_);
  for (size_t k = 0; k < rings_.size(); ++k)
    for (int i = 0; i < atom->nlocal; ++i)
      if (rings_[k]->moves(i))
        sources.moved.push_back({i, static_cast<int>(k), rings_[k]->own_values(i),
                                 rings_[k]->shaft(), rings_[k]->place_on_shaft(i),
                                 rings_[k]->holder()});
  sources.profile = [this](tag_t ring, const raceway::RacewayPhysics *p) {
    return pair_->profiles().of_ring(ring, p);
  };
  if (pair_->profiles().any_ball()) {
    sources.ball_profile = [this](tag_t ball, const raceway::RacewayPhysics *p) {
      return pair_->profiles().of_ball(ball, p);
    };
    sources.turn = [this](int i) -> raceway::Quaternion & { return pair_->state()->turn(i); };
  }
  sources.states = raceway::law_facts(pair_->coefficients().law()).states;
  all.bearings.build(sources, groupbit);
  all.own.clear();
  // A solver stores nothing from earlier steps, so it is reused for any bearing whose law has the
  // same parts. An energy balance needs a new solver.
  std::vector<std::unique_ptr<BearingIntegrator>> earlier;
  if (!energy_wanted_ && !laws_changed_) earlier.swap(all.integrators);
  laws_changed_ = false;
  all.integrators.clear();
  const auto made = [&earlier](const BearingModel &of, size_t likely) {
    const auto fits = [&](const auto &one) { return one && alike(one->model(), of); };
    if (likely < earlier.size() && fits(earlier[likely])) return std::move(earlier[likely]);
    const auto found = std::find_if(earlier.begin(), earlier.end(), fits);
    return found == earlier.end() ? nullptr : std::move(*found);
  };
  all.instants.resize(all.bearings.size());
  // A solver that is shared by identical bearings stays in the caches. An energy balance belongs to
  // one bearing and is needed after its step, so if it is requested, each bearing has a separate
  // solver.
  const bool shared = !energy_wanted_;
  using Kind = std::tuple<const void *, size_t, int>;    // sufficient to distinguish most kinds
  std::map<Kind, std::vector<std::pair<int, BearingIntegrator *>>> kinds;
  for (int p = 0; p < all.bearings.size(); ++p) {
    const BearingModel &model = all.bearings.model(p);
    auto &kind = kinds[{model.grooves.empty() ? nullptr : model.grooves.front().physics,
                        model.bodies.size(), model.rings.front().mover}];
    const raceway::Instants instants = {instants_.number, instants_.states, capacitors_of(model)};
    const auto like =
        std::find_if(shared ? kind.begin() : kind.end(), kind.end(), [&](const auto &one) {
          return one.second->instants().wanted() == instants &&
                 alike(all.bearings.model(one.first), model);
        });
    if (like != kind.end()) {
      all.own.push_back({like->second, 0.0, {}});
      continue;
    }
    BearingModel of = model;
    of.parts = pair_->coefficients().law();
    for (BearingModel::Shaft &one : of.shafts)
      if (const FixBearingShaft *bends = rings_[one.mover]->bending()) one.modes = &bends->modes();
    std::unique_ptr<BearingIntegrator> integrator = made(of, all.integrators.size());
    if (!integrator) {
      integrator = std::make_unique<BearingIntegrator>(of);
      integrator->keep_energy(energy_wanted_);
    }
    integrator->instants().want(instants);
    all.integrators.push_back(std::move(integrator));
    all.own.push_back({all.integrators.back().get(), 0.0, {}});
    kind.push_back({p, all.integrators.back().get()});
  }
}

// Returns the prescribed motion of a ring that no fix moves, which keeps its spin.
static raceway::RingProgram kept_spin(const raceway::RingPose &ring)
{
  constexpr int spin = raceway::RingProgram::SPIN;
  raceway::RingProgram p;
  if (ring.spin == 0.0) return p;
  p.mode[spin] = raceway::Freedom::speed;
  p.target[0][spin] = p.target[1][spin] = ring.spin;
  return p;
}

// Loads the state of a bearing and the prescribed motions of its rings in this step.
void FixBearingImplicit::load(int p, const raceway::Vec3 &fall)
{
  bearing::HomeBearings &bearings = solver_->bearings;
  BearingIntegrator &integrator = *solver_->own[p].integrator;
  const BearingModel &model = bearings.model(p);
  integrator.set_gravity(fall);
  for (size_t k = 0; k < model.rings.size(); ++k) {
    const BearingModel::Ring &ring = model.rings[k];
    if (ring.on_shaft) continue;
    integrator.set_program(static_cast<int>(k), ring.mover < 0
                                                    ? kept_spin(bearings.rings(p)[k])
                                                    : rings_[ring.mover]->program(ring.own));
  }
  int shaft = static_cast<int>(model.rings.size());
  for (const BearingModel::Shaft &s : model.shafts)
    integrator.set_program(shaft++, rings_[s.mover]->program({}));
  load_bends(p);
  integrator.load(bearings.bodies(p), bearings.rings(p));
  integrator.load_states(bearings.states(p).data());
}

void FixBearingImplicit::initial_integrate(int)
{
  pair_->begin_step();
  build();
  for (FixBearingRing *r : rings_) r->begin_step();
  bearing::HomeBearings &bearings = solver_->bearings;
  std::vector<OwnBearing> &own = solver_->own;
  bearings.gather();
  const raceway::Vec3 fall = gravity();
  if (energy_wanted_ && !begun_) {
    for (int p = 0; p < bearings.size(); ++p) load(p, fall);
    begin_energy();
  }
  for (int p = 0; p < bearings.size(); ++p) {
    load(p, fall);
    // the requested substep is stored with the first ring, so that it moves with the bearing to
    // another home rank or into a restart file
    double &wish = bearings.wished_step(p);
    own[p].step = wish > 0.0 ? wish : largest_;
    own[p].integrator->instants().write_to(solver_->instants[p]);
    advance(own[p]);
    turn_instants(p);
    wish = own[p].step;
    own[p].integrator->store(bearings.bodies(p), bearings.rings(p));
    own[p].integrator->store_states(bearings.states(p).data());
  }
  bearings.scatter();
  store_bends();
  time_ += update->dt;
}

// Advances a bearing by one host step, in as few equal substeps as the error control allows.
void FixBearingImplicit::advance(OwnBearing &p)
{
  const double whole = update->dt;
  const BearingIntegrator::Settings &settings = solver_->settings;
  double done = 0.0;
  while (done < whole) {
    const double left = whole - done;
    // the edge of a flaw is an event, so a substep ends there, and substeps across it are short
    const double flaws = p.integrator->longest_step();
    const double pieces = std::ceil(left / std::min(p.step, largest_) - 1e-9);
    const double free = pieces <= 1.0 ? left : left / pieces;
    const bool held = flaws < std::min(free, 0.99 * left), last = !held && pieces <= 1.0;
    const double h = held ? flaws : free;
    p.outcome = p.integrator->step(settings, h, done / whole, last ? 1.0 : (done + h) / whole);
    const BearingIntegrator::Outcome &o = p.outcome;
    corrections_ += o.corrections;
    // ratio of the error to its allowed value, which grows as h^2
    const double excess = std::max(o.error / o.tolerance, o.stability);
    const double fit = 0.9 / std::sqrt(std::max(excess, 1e-6));
    if (!o.solved() || !(excess <= 1.0)) {
      refused_ += 1.0;
      p.step = h * std::min(0.5, std::max(0.2, o.solved() ? fit : 0.25));
      if (p.step < smallest_step) give_up(p, h);
      continue;
    }
    if (const raceway::Failure f = p.integrator->accept(); f != raceway::Failure::none) {
      p.outcome.failure = f;
      give_up(p, h);
    }
    substeps_ += 1.0;
    smallest_ = std::min(smallest_, h);
    worst_ = std::max(worst_, o.error);
    // increase the substep again if the Newton iteration has converged easily
    const double grow = std::min(2.0, std::max(0.5, fit));
    if (o.corrections <= settings.corrections &&
        (grow < 1.0 || (!held && (!last || h > 0.99 * p.step))))
      p.step = std::min(grow * h, whole);
    done = last ? whole : done + h;
  }
}

static std::string cause(raceway::Failure f, const std::string &who)
{
  using raceway::Failure;
  switch (f) {
    case Failure::not_a_number: return "the velocity of " + who + " is not a number";
    case Failure::outside_groove:
      return "the overlap of " + who +
             " is beyond the overlap limit, or its contact ellipse is as wide as the groove";
    case Failure::turned_too_far: return "a body turns too far in one stage";
    case Failure::other_links: return "cage contacts open and close between corrections";
    default: return "corrections do not converge";
  }
}

void FixBearingImplicit::give_up(const OwnBearing &p, double h) const
{
  const BearingIntegrator::Outcome &o = p.outcome;
  const BearingModel &m = solver_->bearings.model(&p - solver_->own.data());
  const std::string where =
      bearing::name_of(*this) + " at step " + std::to_string(update->ntimestep);
  const std::string who =
      o.body >= 0 ? "atom " + std::to_string(m.bodies[o.body].tag) : std::string("a body");
  if (o.failure == raceway::Failure::overlinked)
    BRG_ONE(where + ": " + who + " touches more than two balls or cage balls");
  BRG_ONE(where + ": no solution with substeps down to " + text(h) + " s; last correction " +
          text(o.last) + " m, estimated error " + text(o.error) + " m, tolerance " +
          text(o.tolerance) + " m; " +
          (o.solved() ? "the error is too large" : cause(o.failure, who)) +
          ". Is the load too high, are the rings apart, or do bodies overlap at the start?");
  std::abort();
}
