// SPDX-License-Identifier: GPL-2.0-or-later
#include "fix_bearing_implicit.h"

#include "../contacts/fix_columns.h"
#include "../deck/arguments.h"
#include "../implicit/alike_bearings.h"
#include "../implicit/bearing_step.h"
#include "../ranks/bearing_parts.h"
#include "../ranks/gather.h"
#include "fix_bearing_cage.h"
#include "fix_bearing_ring.h"
#include "fix_bearing_shaft.h"
#include "fix_bearing_state.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"
#include "ring_values.h"

#include <algorithm>
#include <map>
#include <tuple>

using namespace LAMMPS_NS;
using namespace FixConst;
using bearing::Arguments;
using bearing::Instants;
using bearing::tag_t;
using bearing::text;
using raceway::BearingModel;
using raceway::BearingStep;

static constexpr double smallest_step = 1e-12;    // s

struct FixBearingImplicit::Part {
  BearingStep *bearing;
  double step;                     // s, the control's wish for the next substep
  BearingStep::Outcome outcome;    // of the last substep that was tried
};

struct FixBearingImplicit::Solver {
  BearingStep::Settings settings;
  BearingStep::Energy energy;    // of bearings of earlier neighbour builds
  bearing::BearingParts bearings;
  std::vector<Part> parts;    // one a bearing at home here
  std::vector<std::unique_ptr<BearingStep>> steps;
  std::vector<raceway::BearingInstants::Contact> contacts;    // of the instant that is read
};

// fix ID group bearing/implicit [solve all|damping] [tolerance T] [relative R] [cage_tolerance TC]
// [order 1|2] [corrections N] [largest H] [creep C] [energy yes|no]
FixBearingImplicit::FixBearingImplicit(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair_(PairBearingHertz::find(lmp, "fix bearing/implicit")),
    solver_(new Solver{{}, {}, {lmp, std::string("fix ") + id + " bearing/implicit"}, {}, {}, {}})
{
  BearingStep::Settings &settings = solver_->settings;
  double cage = 0.0;
  Arguments args(lmp, std::string("fix ") + id + " bearing/implicit", narg, arg, 3);
  while (args.more()) {
    if (args.take("tolerance")) tolerance_ = args.within("tolerance (m)", 1e-13, 1e-5);
    else if (args.take("cage_tolerance"))
      cage = args.within("tolerance of cage balls (m)", 1e-13, 1e-3);
    else if (args.take("relative"))
      settings.relative = args.within("tolerance relative to the largest overlap", 0.0, 1e-2);
    else if (args.take("solve")) settings.dampers_only = args.choice("solve", {"all", "damping"});
    else if (args.take("order")) settings.order = args.integer("order", 1, 2);
    else if (args.take("corrections"))
      settings.corrections = args.integer("corrections in a stage", 1, 100);
    else if (args.take("largest"))
      largest_ = args.within("largest step (s)", smallest_step, HUGE_VAL);
    else if (args.take("creep")) creep_ = args.within("creep of the smoothed friction", 1e-6, 1.0);
    else if (args.take("energy")) energy_wanted_ = args.choice("energy", {"no", "yes"});
    else
      args.unknown(
          "solve, tolerance, relative, cage_tolerance, order, corrections, largest, creep, energy");
  }
  if (settings.dampers_only && settings.relative > 0.0)
    args.fail("relative is " + text(settings.relative) +
              ", must be 0 with 'solve damping', whose tolerance is how far a ball may move");
  if (tolerance_ == 0.0) tolerance_ = settings.dampers_only ? 1e-7 : 1e-9;
  settings.newton = tolerance_;
  if (cage > 0.0 && cage < tolerance_)
    BRG_ALL(std::string("fix ") + id + " bearing/implicit: tolerance of cage balls (m) is " +
            text(cage) + ", below the tolerance of " + text(tolerance_));
  if (cage > 0.0) settings.cage = cage / tolerance_;
  time_integrate = 1;
  scalar_flag = vector_flag = 1;
  size_vector = bearing::of_fix_implicit::N;
  global_freq = 1;
  extscalar = extvector = 0;
}

FixBearingImplicit::~FixBearingImplicit() = default;

int FixBearingImplicit::setmask() { return INITIAL_INTEGRATE; }

void FixBearingImplicit::init()
{
  pair_ = PairBearingHertz::find(lmp, "fix bearing/implicit");
  gravity_.clear();
  check_fixes();
  find_rings();
  instants_ = Instants();
  if (pair_->smooth_friction(creep_) && comm->me == 0) {
    const std::string say = std::string("fix ") + id +
                            " bearing/implicit: friction smoothed over a creep of " + text(creep_) +
                            " of the entrainment speed\n";
    if (screen) fputs(say.c_str(), screen);
    if (logfile) fputs(say.c_str(), logfile);
  }
}

// Fixes whose rings are in the group: the same list on all ranks, which own different rings or
// none.
void FixBearingImplicit::find_rings()
{
  const std::vector<FixBearingRing *> all = bearing::fixes_of<FixBearingRing>(lmp);
  std::vector<int> seen;    // two a fix: rings in the group, rings outside
  for (const FixBearingRing *r : all) {
    int mine = 0, others = 0;
    for (int i = 0; i < atom->nlocal; ++i)
      if (r->moves(i)) (atom->mask[i] & groupbit ? mine : others) = 1;
    seen.push_back(mine);
    seen.push_back(others);
  }
  MPI_Allreduce(MPI_IN_PLACE, seen.data(), static_cast<int>(seen.size()), MPI_INT, MPI_MAX, world);
  rings_.clear();
  for (size_t k = 0; k < all.size(); ++k) {
    if (!seen[2 * k]) continue;
    if (seen[2 * k + 1])
      BRG_ALL(std::string("fix ") + id + " bearing/implicit: its group has some rings of fix " +
              all[k]->id + " but not all of them");
    if (solver_->settings.dampers_only && all[k]->bending())
      BRG_ALL(bearing::name_of(*all[k]) + ": a flexible shaft needs 'solve all' of fix " + id +
              " bearing/implicit");
    rings_.push_back(all[k]);
  }
}

// Nobody else moves these atoms, and nobody pushes them unseen.
void FixBearingImplicit::check_fixes()
{
  // an atom of this group and of the fix's, 0: none
  auto shared = [this](const Fix &f) {
    for (int i = 0; i < atom->nlocal; ++i)
      if ((atom->mask[i] & groupbit) && (atom->mask[i] & f.groupbit)) return i + 1;
    return 0;
  };
  for (const FixBearingImplicit *f : bearing::fixes_of<FixBearingImplicit>(lmp))
    if (f != this)
      if (const int i = shared(*f))
        BRG_ONE(std::string("fix ") + id + " bearing/implicit and fix " + f->id +
                " both move atom " + std::to_string(atom->tag[i - 1]));
  for (int k = 0; k < modify->nfix; ++k) {
    const Fix &f = *modify->fix[k];
    if (strncmp(f.style, "bearing/", 8) == 0) continue;    // ours: the step knows what they do
    if (strcmp(f.style, "gravity") == 0) {
      add_gravity(*modify->fix[k]);
      continue;
    }
    const char *does = f.time_integrate                ? "moves them too"
                       : modify->fmask[k] & POST_FORCE ? "adds forces that "
                                                         "an implicit step does not see"
                                                       : nullptr;
    if (does && shared(f))
      BRG_ONE(std::string("fix ") + id + " bearing/implicit: its group has atoms of fix " + f.id +
              " (" + f.style + "), which " + does);
  }
}

// Gravity is the same for all bodies of a bearing, or the step would not know where it acts.
void FixBearingImplicit::add_gravity(Fix &f)
{
  int inside = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) inside |= atom->mask[i] & f.groupbit ? 1 : 2;
  MPI_Allreduce(MPI_IN_PLACE, &inside, 1, MPI_INT, MPI_BOR, world);
  if (inside == 3)
    BRG_ALL(std::string("fix ") + id + " bearing/implicit: fix " + f.id +
            " (gravity) pulls some atoms of its group, but not all of them");
  if (inside == 1) gravity_.push_back(&f);
}

// m/s^2 in this step, the bearing axis third: what the fixes do to an atom. All ranks ask, since a
// variable may be evaluated.
raceway::Vec3 FixBearingImplicit::gravity()
{
  if (gravity_.empty()) return {};
  const size_t n = 3 * static_cast<size_t>(atom->nlocal);
  if (n > 0) forces_.assign(&atom->f[0][0], &atom->f[0][0] + n);
  raceway::Vec3 fall;
  int one = 0;
  while (one < atom->nlocal && !(atom->mask[one] & groupbit)) ++one;
  if (one < atom->nlocal) fall.to(atom->f[one]);
  for (Fix *f : gravity_) f->post_force(0);
  if (one < atom->nlocal) fall = raceway::Vec3::from(atom->f[one]) * (1.0 / atom->rmass[one]);
  if (n > 0) std::copy(forces_.begin(), forces_.end(), &atom->f[0][0]);
  return raceway::LabAxes{pair_->axis_index()}.third(fall);
}

void FixBearingImplicit::setup(int)
{
  build_ = -1;
  substeps_ = corrections_ = refused_ = time_ = worst_ = 0.0;
  solver_->energy = BearingStep::Energy();
  begun_ = false;
  smallest_ = HUGE_VAL;
}

void FixBearingImplicit::build()
{
  if (build_ == pair_->table_build()) return;
  build_ = pair_->table_build();
  Solver &all = *solver_;
  for (const auto &step : all.steps) {    // what the bearings of the last build have to say
    all.energy.work += step->spent().work;
    all.energy.dissipated += step->spent().dissipated;
  }
  bearing::BearingSources sources;
  sources.table = &pair_->table();
  sources.axes.along = pair_->axis_index();
  for (const FixBearingCage *c : bearing::fixes_of<FixBearingCage>(lmp))
    sources.cages.push_back(&c->rails());
  for (size_t k = 0; k < rings_.size(); ++k)
    for (int i = 0; i < atom->nlocal; ++i)
      if (rings_[k]->moves(i))
        sources.moved.push_back({i, static_cast<int>(k), rings_[k]->own_values(i),
                                 rings_[k]->shaft(), rings_[k]->place_on_shaft(i)});
  sources.is_ring = [this](int type) { return pair_->is_ring_type(type); };
  sources.is_ball = [this](int type) { return pair_->is_ball_type(type); };
  sources.raceway = [this](int ball, int ring, int) { return pair_->raceway(ball, ring); };
  sources.profile = [this](tag_t ring, const raceway::RacewayPhysics *p) {
    return pair_->profile(ring, p);
  };
  raceway::with_law(pair_->law(), [&](auto law) { sources.states = decltype(law)::states; });
  sources.motion = [this](int i) -> bearing::RingMotion & { return pair_->state()->ring(i); };
  all.bearings.build(sources, groupbit);
  all.parts.clear();
  all.steps.clear();
  // One solver for all bearings that are alike stays in the caches. An account of the energy and
  // instants stay with a bearing after its step, so there each has its own.
  const bool shared = !energy_wanted_ && instants_.number < 2;
  using Kind = std::tuple<const void *, size_t, int>;    // tells most kinds apart
  std::map<Kind, std::vector<std::pair<int, BearingStep *>>> kinds;
  for (int p = 0; p < all.bearings.size(); ++p) {
    const BearingModel &model = all.bearings.model(p);
    auto &kind = kinds[{model.grooves.empty() ? nullptr : model.grooves.front().physics,
                        model.bodies.size(), model.rings.front().mover}];
    const auto like =
        std::find_if(shared ? kind.begin() : kind.end(), kind.end(),
                     [&](const auto &one) { return alike(all.bearings.model(one.first), model); });
    if (like != kind.end()) {
      all.parts.push_back({like->second, 0.0, {}});
      continue;
    }
    BearingModel of = model;
    of.parts = pair_->law();
    for (BearingModel::Shaft &one : of.shafts)
      if (const FixBearingShaft *bends = rings_[one.mover]->bending()) one.modes = &bends->modes();
    all.steps.push_back(std::make_unique<BearingStep>(of));
    all.parts.push_back({all.steps.back().get(), 0.0, {}});
    kind.push_back({p, all.steps.back().get()});
    all.steps.back()->keep_energy(energy_wanted_);
    all.steps.back()->instants().want({instants_.number, instants_.capacitor});
  }
}

// What is stored before the first step of a run.
void FixBearingImplicit::begin_energy()
{
  stored_before_ = 0.0;
  for (const auto &step : solver_->steps) stored_before_ += step->energy().stored;
  MPI_Allreduce(MPI_IN_PLACE, &stored_before_, 1, MPI_DOUBLE, MPI_SUM, world);
  begun_ = true;
}

// The state of a bearing, and what its rings are told to do in this step.
void FixBearingImplicit::load(int p, const raceway::Vec3 &fall)
{
  bearing::BearingParts &bearings = solver_->bearings;
  BearingStep &step = *solver_->parts[p].bearing;
  const BearingModel &model = bearings.model(p);
  step.set_gravity(fall);
  for (size_t k = 0; k < model.rings.size(); ++k)
    if (model.rings[k].mover >= 0 && !model.rings[k].on_shaft)
      step.set_program(static_cast<int>(k),
                       rings_[model.rings[k].mover]->program(model.rings[k].own));
  int shaft = static_cast<int>(model.rings.size());
  for (const BearingModel::Shaft &s : model.shafts)
    step.set_program(shaft++, rings_[s.mover]->program({}));
  load_bends(p);
  step.load(bearings.bodies(p), bearings.rings(p));
  step.load_states(bearings.states(p).data());
}

void FixBearingImplicit::initial_integrate(int)
{
  build();
  for (FixBearingRing *r : rings_) r->begin_step();
  bearing::BearingParts &bearings = solver_->bearings;
  std::vector<Part> &parts = solver_->parts;
  bearings.gather();
  const raceway::Vec3 fall = gravity();
  if (energy_wanted_ && !begun_) {
    for (int p = 0; p < bearings.size(); ++p) load(p, fall);
    begin_energy();
  }
  for (int p = 0; p < bearings.size(); ++p) {
    load(p, fall);
    // the control's wish is kept with the ring, so that it goes with the bearing to another home or
    // into a restart file
    double &wish = bearings.wished_step(p);
    parts[p].step = wish > 0.0 ? wish : largest_;
    advance(parts[p]);
    wish = parts[p].step;
    parts[p].bearing->store(bearings.bodies(p), bearings.rings(p));
    parts[p].bearing->store_states(bearings.states(p).data());
  }
  bearings.scatter();
  store_bends();
  time_ += update->dt;
}

// Shafts that bend: from their fixes to the bearings at home here.
void FixBearingImplicit::load_bends(int p)
{
  int shaft = 0;
  for (const BearingModel::Shaft &s : solver_->bearings.model(p).shafts) {
    if (const FixBearingShaft *bends = rings_[s.mover]->bending()) {
      solver_->parts[p].bearing->set_bend(shaft, bends->bend_program());
      solver_->parts[p].bearing->load_bend(shaft, bends->bend());
    }
    ++shaft;
  }
}

// And back, to all ranks.
void FixBearingImplicit::store_bends()
{
  for (int k = 0; k < static_cast<int>(rings_.size()); ++k) {
    FixBearingShaft *bends = rings_[k]->bending();
    if (!bends) continue;
    raceway::BendState state;
    for (int p = 0; p < solver_->bearings.size(); ++p) {
      int shaft = 0;
      for (const BearingModel::Shaft &s : solver_->bearings.model(p).shafts) {
        if (s.mover == k) state = solver_->parts[p].bearing->stored_bend(shaft);
        ++shaft;
      }
    }
    bends->set_bend(
        {bearing::gather_all(state.place, world), bearing::gather_all(state.rate, world)});
  }
}

// The host's step in equal substeps, as few as the control allows.
void FixBearingImplicit::advance(Part &p)
{
  const double whole = update->dt;
  const BearingStep::Settings &settings = solver_->settings;
  double done = 0.0;
  while (done < whole) {
    const double left = whole - done;
    // the edge of a flaw is an event: a step ends there, and over it steps are short
    const double flaws = p.bearing->longest_step();
    const double pieces = std::ceil(left / std::min(p.step, largest_) - 1e-9);
    const double free = pieces <= 1.0 ? left : left / pieces;
    const bool held = flaws < std::min(free, 0.99 * left), last = !held && pieces <= 1.0;
    const double h = held ? flaws : free;
    p.outcome = p.bearing->step(settings, h, done / whole, last ? 1.0 : (done + h) / whole);
    const BearingStep::Outcome &o = p.outcome;
    corrections_ += o.corrections;
    // over what is allowed; grows like h^2
    const double excess = std::max(o.error / o.tolerance, o.stability);
    const double fit = 0.9 / std::sqrt(std::max(excess, 1e-6));
    if (!o.solved() || !(excess <= 1.0)) {
      refused_ += 1.0;
      p.step = h * std::min(0.5, std::max(0.2, o.solved() ? fit : 0.25));
      if (p.step < smallest_step) give_up(p, h);
      continue;
    }
    if (const raceway::Failure f = p.bearing->accept(); f != raceway::Failure::none) {
      p.outcome.failure = f;
      give_up(p, h);
    }
    substeps_ += 1.0;
    smallest_ = std::min(smallest_, h);
    worst_ = std::max(worst_, o.error);
    // grow back where Newton had an easy time
    const double grow = std::min(2.0, std::max(0.5, fit));
    if (o.corrections <= settings.corrections &&
        (grow < 1.0 || (!held && (!last || h > 0.99 * p.step))))
      p.step = std::min(grow * h, whole);
    done = last ? whole : done + h;
  }
}

// Those who want the same instants share one evaluation.
void FixBearingImplicit::want_instants(const Instants &i, const std::string &command)
{
  const bool others = instants_.number > 1;
  if (others && i.number != instants_.number)
    BRG_ALL(command + ": 'within " + std::to_string(i.number) +
            "', but another fix wants 'within " + std::to_string(instants_.number) + "' of fix " +
            id + " bearing/implicit");
  const bool capacitor = i.capacitor.permittivity > 0.0;
  if (others && capacitor && instants_.capacitor.permittivity > 0.0 &&
      i.capacitor != instants_.capacitor)
    BRG_ALL(command + ": two fixes want different things between the steps of fix " + id +
            " bearing/implicit; give them the same permittivity, film_floor, permittivity_at, "
            "surroundings, shoulders and roughness");
  if (capacitor || !others) instants_ = i;
}

void FixBearingImplicit::read_instant(int k, const bearing::InstantReader &tell) const
{
  const raceway::LabAxes axes = {pair_->axis_index()};
  for (int p = 0; p < static_cast<int>(solver_->parts.size()); ++p) {
    const BearingModel &m = solver_->bearings.model(p);
    const raceway::BearingInstants &at = solver_->parts[p].bearing->instants();
    at.contacts(k, tell.states, solver_->contacts);
    for (int g = 0; g < static_cast<int>(m.grooves.size()); ++g) {
      const raceway::BearingModel::Groove &groove = m.grooves[g];
      raceway::BearingInstants::Contact &c = solver_->contacts[g];
      if (tell.states) {
        c.state.u = axes.lab(c.state.u);
        c.state.t = axes.lab(c.state.t);
      }
      tell.contact({static_cast<tag_t>(m.bodies[groove.body].tag),
                    static_cast<tag_t>(m.rings[groove.ring].tag), *groove.physics, c.orbit, c.live,
                    c.load, c.capacitor, c.state});
    }
    if (tell.body)
      for (int b = 0; b < static_cast<int>(m.bodies.size()); ++b) {
        const raceway::BodyPose pose = at.body(k, b);
        // the step leaves the spin of a cage ball alone
        const raceway::Vec3 &w = m.bodies[b].spins ? pose.w : solver_->bearings.bodies(p)[b].w;
        tell.body(
            {static_cast<tag_t>(m.bodies[b].tag), axes.lab(pose.x), axes.lab(pose.v), axes.lab(w)});
      }
    if (tell.ring)
      for (int r = 0; r < static_cast<int>(m.rings.size()); ++r) {
        const raceway::BearingInstants::Ring &now = at.ring(k, r);
        bearing::InstantRing ring;
        bearing::ring_values({static_cast<double>(m.rings[r].tag), now.pose, now.pose.spin,
                              now.force, now.moment, now.acceleration},
                             axes, ring.of);
        tell.ring(ring);
      }
  }
}

static std::string cause(raceway::Failure f, const std::string &who)
{
  using raceway::Failure;
  switch (f) {
    case Failure::not_a_number: return "the velocity of " + who + " is not a number";
    case Failure::outside_groove:
      return "the overlap of " + who +
             " is beyond the overlap limit, or its contact ellipse as wide as the groove";
    case Failure::turned_too_far: return "a body turns too far for one stage";
    case Failure::other_links: return "cage contacts open and close between corrections";
    default: return "corrections do not converge";
  }
}

void FixBearingImplicit::give_up(const Part &p, double h) const
{
  const BearingStep::Outcome &o = p.outcome;
  const BearingModel &m = solver_->bearings.model(&p - solver_->parts.data());
  const std::string where =
      std::string("fix ") + id + " bearing/implicit at step " + std::to_string(update->ntimestep);
  const std::string who =
      o.body >= 0 ? "atom " + std::to_string(m.bodies[o.body].tag) : std::string("a body");
  if (o.failure == raceway::Failure::overlinked)
    BRG_ONE(where + ": " + who + " touches more than two balls or cage balls");
  BRG_ONE(where + ": no solution with substeps down to " + text(h) + " s; last correction " +
          text(o.last) + " m, estimated error " + text(o.error) + " m, tolerance " +
          text(o.tolerance) + " m; " +
          (o.solved() ? "the error is too large" : cause(o.failure, who)) +
          ". Load too high, rings apart, or the start overlaps");
  std::abort();
}

double FixBearingImplicit::compute_scalar()
{
  return compute_vector(bearing::of_fix_implicit::MEAN_STEP);
}

// Over all bearings since the start of the run (bearing::of_fix_implicit); energies are 0 unless
// asked for.
double FixBearingImplicit::compute_vector(int k)
{
  BearingStep::Energy e = solver_->energy;
  for (const auto &step : solver_->steps)
    if (energy_wanted_) {
      const BearingStep::Energy &now = step->energy();
      e.work += now.work;
      e.dissipated += now.dissipated;
      e.stored += now.stored;
    }
  double sum[] = {substeps_, corrections_, refused_, static_cast<double>(solver_->parts.size()),
                  e.work,    e.dissipated, e.stored};
  double most[] = {worst_, -smallest_};
  MPI_Allreduce(MPI_IN_PLACE, sum, 7, MPI_DOUBLE, MPI_SUM, world);
  MPI_Allreduce(MPI_IN_PLACE, most, 2, MPI_DOUBLE, MPI_MAX, world);
  const double n = std::max(sum[0], 1.0), bearings = std::max(sum[3], 1.0),
               stored = sum[6] - stored_before_;
  using namespace bearing::of_fix_implicit;
  switch (k) {
    case MEAN_STEP: return time_ * bearings / n;
    case SMALLEST_STEP: return sum[0] > 0.0 ? -most[1] : 0.0;
    case STEPS: return sum[0];
    case CORRECTIONS: return sum[1] / n;
    case REFUSED: return sum[2];
    case ERROR: return most[0];
    case WORK: return sum[4];
    case DISSIPATED: return sum[5];
    case STORED: return energy_wanted_ ? stored : 0.0;
    case LOST: return energy_wanted_ ? sum[4] - sum[5] - stored : 0.0;
  }
  return 0.0;
}
