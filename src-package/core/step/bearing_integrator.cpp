// SPDX-License-Identifier: GPL-2.0-or-later
// Performs the sequence of operations in a step. The energy of a step is computed in
// bearing_energy.cpp.
#include "bearing_integrator.h"

#include <algorithm>

namespace raceway {

static const double gamma_2 = 1.0 - std::sqrt(0.5);     // length of a stage divided by h, for order
                                                        // 2
static const double beyond_2 = 1.0 + std::sqrt(2.0);    // (1 - gamma)/gamma
// Position error of the method for a velocity that grows with the square of time, divided by h
// times the second divided difference of the velocities at 0, gamma h and h. For a free vibration,
// in which the error of the first stage is of second order, the error is 6.8 times as large.
static const double bend_2 = gamma_2 + (1.0 - gamma_2) * gamma_2 * gamma_2 - 1.0 / 3.0;

static BearingIntegrator::Outcome &failed(BearingIntegrator::Outcome &o, Failure why, int body = -1)
{
  o.failure = why;
  o.body = body;
  return o;
}

BearingIntegrator::Settings BearingIntegrator::Settings::at(double overlap) const
{
  Settings result = *this;
  result.newton = std::max(newton, relative * overlap);
  result.cage = std::max(1.0, cage * newton / result.newton);
  return result;
}

ShaftBend &BearingIntegrator::bend(int shaft)
{
  const int ring = static_cast<int>(bodies_.model.rings.size()) + shaft;
  return *std::find_if(bodies_.bends.begin(), bodies_.bends.end(),
                       [ring](const ShaftBend &b) { return b.shaft == ring; });
}

BearingIntegrator::Outcome BearingIntegrator::step(const Settings &asked, double h, double s0,
                                                   double s1)
{
  const Settings set = asked.relative > 0.0 ? asked.at(forces_.largest_overlap()) : asked;
  Outcome o;
  o.tolerance = set.error * set.newton;
  if (keep_energy_ && !balanced_) {
    stored_energy();
    for (BearingBodies::BalancedContact &c : bodies_.balanced) c.from = c.now;
    balanced_ = true;
  }
  pending_ = Energy();
  present_ = {h, s0, s1};
  if (s0 == 0.0) remains_ = 1.0;    // it must not depend on earlier steps of the host
  bodies_.start();
  if (set.dampers_only) {
    const double middle = 0.5 * (s0 + s1);
    if (!coast(0.5 * h, middle, false)) return failed(o, Failure::turned_too_far);
    if (!solve_stage(set, h, middle, o)) return o;
    o.stability = stability(h);
    if (keep_energy_) add_energy({h, true}, h, middle);
    if (!coast(0.5 * h, s1, true)) return failed(o, Failure::turned_too_far);
  } else if (set.order == 1) {
    if (!solve_stage(set, h, s1, o)) return o;
    if (keep_energy_) add_energy({h}, h, s1);
  } else {
    const double stage = gamma_2 * h;
    if (!solve_stage(set, stage, s0 + gamma_2 * (s1 - s0), o)) return o;
    if (keep_energy_) add_energy({stage}, (1.0 - gamma_2) * h, s0 + gamma_2 * (s1 - s0));
    bodies_.second_base(beyond_2);
    if (!solve_stage(set, stage, s1, o)) return o;
    if (keep_energy_) add_energy({stage}, stage, s1);
  }
  o.error = error(h, set);
  o.failure = Failure::none;
  return o;
}

// Returns the mass divided by the stiffness for the slowest contact between a ball and a cage ball,
// kg m^1.5/N.
static double slowest_contact(const BearingModel &model)
{
  double slowest = 0.0;
  for (const BearingModel::Pocket &p : model.pockets) slowest = std::max(slowest, p.mass / p.K);
  return slowest;
}

BearingIntegrator::BearingIntegrator(const BearingModel &model) :
    bodies_(model), system_(bodies_), forces_(bodies_, system_), instants_(bodies_, forces_),
    slowest_(slowest_contact(model))
{
}

// The last correction of a one-piece cage may be up to a thirtieth of its allowed error, regardless
// of the length of the stage.
static constexpr double of_ring = 30.0;

// Returns the weight of a cage ball's last correction in a stage of h seconds. The tolerance of the
// correction is a tenth of the tolerance of the error. The error that remains in a contact force
// moves the cage ball by an amount that grows with the square of the stage's length. The tolerance
// is therefore tightened further if the stage is longer than an impact with an overlap equal to the
// tolerance, which lasts half a period of the contact.
double BearingIntegrator::cage_correction(const Settings &set, double h) const
{
  if (!(set.cage > 10.0)) return 1.0;
  if (!bodies_.model.cages.empty()) return std::min(1.0, of_ring / set.cage);
  const double stiffness = 1.5 * std::sqrt(set.cage * set.newton);    // stiffness divided by K
  const double pi = std::acos(-1.0), lasts2 = pi * pi * slowest_ / stiffness;
  const double finer = h * h > lasts2 ? 10.0 * h * h / lasts2 : 10.0;
  return set.cage > finer ? finer / set.cage : 1.0;
}

// Returns a bound on all later corrections relative to the last one. Because Newton's method
// converges, all later corrections add up to at most q/(1 - q) times the last one if that was q
// times the previous one. The result is at least 0.1.
static double remaining(double q) { return q < 0.5 ? std::max(0.1, q / (1.0 - q)) : 1.0; }

bool BearingIntegrator::solve_stage(const Settings &set, double h, double s, Outcome &o)
{
  double before = HUGE_VAL, bodies_before = HUGE_VAL;
  bool fresh = true;
  int evaluated = 0;
  const double cage_counts = cage_correction(set, h);
  Stage stage;
  stage.h = h;
  stage.dampers_only = set.dampers_only;
  if (!set.dampers_only) {
    stage.close = set.newton;
    stage.close_cage = set.newton / cage_counts;
  }
  if (!move(h, s, set.dampers_only)) return failed(o, Failure::turned_too_far).solved();
  stage.keep = set.estimate;
  const int most = stage.keep ? 3 * set.corrections : set.corrections;
  for (int n = 1; n <= most && evaluated < set.corrections; ++n) {
    stage.evaluate = fresh ? Evaluate::derivatives : Evaluate::residual;
    if (!stage.kept) system_.start(h, fresh);
    Failure failure = forces_.evaluate(stage);
    if (failure == Failure::other_links && !fresh) {
      fresh = true;
      stage.evaluate = Evaluate::derivatives;
      system_.start(h, fresh);
      failure = forces_.evaluate(stage);
    }
    if (failure != Failure::none) return failed(o, failure, forces_.body()).solved();
    system_.add_border(h, stage.follows(), s, fresh);
    if (stage.kept) system_.add_kept();
    if (fresh) system_.factor();
    system_.solve();
    if (!stage.kept) {
      ++evaluated;
      ++o.corrections;
    }
    apply(h, cage_counts, o);
    const double last = std::max(o.last, o.last_cage);
    if (!(last < HUGE_VAL)) return failed(o, Failure::not_a_number, o.body).solved();
    // only half of a correction is applied if a contact alternately opens and closes
    if (n > 2 && last > 0.7 * before) halve();
    if (!move(h, s, set.dampers_only)) return failed(o, Failure::turned_too_far).solved();
    if (stage.keep) {
      if (!stage.kept) {
        if (n > 1) remains_ = remaining(o.last / bodies_before);
        bodies_before = o.last;
      }
      const double enough = set.newton / remains_;
      const bool followed = o.last <= enough && forces_.follow(enough);
      if (followed && o.last_cage <= set.newton) return true;
      stage.kept = followed;
    } else if (last <= set.newton && forces_.follow(set.newton)) {
      return true;
    }

    // the last derivatives suffice as long as the residual is small and each correction is less
    // than a tenth of the previous one; otherwise a contact may open or close
    fresh = stage.kept || !(last < 0.1 * before && last < 3.0 * set.newton);
    before = last;
  }
  o.last = std::max(o.last, o.last_cage);
  if (set.corrections > 1) return failed(o, Failure::not_converged).solved();
  forces_.follow(set.newton);
  return true;
}

// Moves all bodies to the end of the stage at the current velocities. Returns false if a body turns
// too far for one stage.
RACEWAY_LANES bool BearingIntegrator::move(double h, double s, bool dampers_only)
{
  if (dampers_only) {
    for (RingBody &r : bodies_.rings) r.now = kicked(r.program, r.base, r.gained);
    bodies_.carry();
    return true;
  }
  LaneMask far = {};
  for (BodyGroup &g : bodies_.groups) {
    g.now = g.base.drifted(g.v, h, g.turn);
    far |= ~(magnitude(g.turn) * beyond_2 <
             largest_turn);    // rotation in the extrapolation to the base of a second stage
  }
  for (BallTurns &t : bodies_.turns) t.move(bodies_.groups[t.group], h);
  bodies_.on_border([h, s](auto &one) { one.move(h, s); });
  bodies_.carry();
  return !any(far);
}

// Moves all bodies for h seconds, either to the middle of a step or from the middle to the end.
// Returns false if a body turns too far.
RACEWAY_LANES bool BearingIntegrator::coast(double h, double s, bool to_end)
{
  LaneMask far = {};
  for (BodyGroup &g : bodies_.groups) {
    if (to_end) g.turned += g.turn;
    const LaneFrame start = to_end ? g.now : g.from;
    g.now = start.drifted(g.v, h, g.turn);
    far |= ~(magnitude(g.turn) < largest_turn);
  }
  for (BallTurns &t : bodies_.turns) t.coast(bodies_.groups[t.group], h, to_end);
  for (RingBody &r : bodies_.rings)
    r.base = r.now = coasted(r.program, to_end ? r.now : r.from, h, s);
  bodies_.carry();
  return !any(far);
}

// Returns the stiffness of a ring's stiffest support divided by the ring's mass, 1/s^2; if another
// ring holds this ring, the term with the holder's mass is added. Supports that connect either ring
// to the ground or to a third ring are included at the holder, so the result is a bound.
static double stiffest(const RingProgram &p, const RingProgram *holder)
{
  double most = 0.0;
  for (int k = 0; k < RingProgram::SPIN; ++k) {
    if (!p.free(k)) continue;
    double sum = p.support[k].stiffness / p.inertia_of(k);
    if (holder && holder->free(k))
      sum += (p.support[k].stiffness + holder->support[k].stiffness) / holder->inertia_of(k);
    most = std::max(most, sum);
  }
  return most;
}

RACEWAY_LANES double BearingIntegrator::stability(double h) const
{
  Lane most = {};
  for (const BodyGroup &g : bodies_.groups) {
    const Lane share = h * h * g.spring / (3.0 * g.mass + 1.5 * h * g.damper);
    most = where(g.used & (share > most), share, most);
  }
  double largest = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  for (const RingBody &r : bodies_.rings)
    if (r.loose && r.program.mass > 0.0)
      largest = std::max(largest, h * h * r.spring / (3.0 * r.program.mass));
  std::vector<double> of_shafts(bodies_.model.shafts.size(), 0.0);    // 1/s^2
  for (const BearingBodies::Carried &c : bodies_.on_shafts) {
    const RingBody &ring = bodies_.rings[c.ring];
    const RingProgram &p = bodies_.rings[c.shaft].program;
    double &sum = of_shafts[c.shaft - bodies_.model.rings.size()];
    if (p.mass > 0.0) sum += ring.spring / p.mass;
    if (p.tilts_free()) sum += ring.spring * ring.at * ring.at / p.inertia.transverse;
    largest = std::max(largest, h * h * sum / 3.0);
  }
  for (const RingBody &r : bodies_.rings)
    if (r.program.supported) {
      const RingProgram *holder = r.holder < 0 ? nullptr : &bodies_.rings[r.holder].program;
      largest = std::max(largest, h * h * stiffest(r.program, holder) / 3.0);
    }
  return largest;
}

// Returns the larger magnitude of the two components normal to the rolling direction.
static RACEWAY_INLINE Lane across(const Vec3L &v)
{
  return where(magnitude(v.x) > magnitude(v.z), magnitude(v.x), magnitude(v.z));
}

// Returns the stiffness of the stiffest contact between a ball and a raceway when derivatives were
// last evaluated, N/m.
RACEWAY_LANES double BearingIntegrator::largest_stiffness() const
{
  Lane most = {};
  for (const BodyGroup &g : bodies_.groups) most = where(g.stiffness > most, g.stiffness, most);
  return std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
}

// Contact stiffness varies as the cube root of the load, so a fifth of the largest stiffness
// corresponds to about a hundredth of the largest load.
static constexpr double light = 0.2, least_count = 0.1;

// Safety factor for the error estimate.
static constexpr double safe = 4.0;

// Returns the weight of the error bound relative to the estimate. The estimate applies to one step
// of smooth motion, whereas a vibration accumulates the errors of all its steps. With the weight w,
// a vibration that determines the step lags by less than 0.195 s/w times the tolerance after s
// radians (docs/fix_bearing_implicit). A relative tolerance serves the loads of steady operation,
// in which vibrations die out.
static double sudden(double relative) { return relative > 0.0 ? 0.3 : 0.7; }

// Weights of two error measures: the change of velocity between the stages, and the second
// difference.
struct ErrorWeights {
  double change = 1.0, bend = 0.0;
};

// Returns the larger of the two weighted measures, m/s.
template <class T>
static RACEWAY_INLINE T changed(const ErrorWeights &w, const T &from, const T &first, const T &end)
{
  const T change = w.change * magnitude(T(end - first));
  if (w.bend == 0.0) return change;
  const T bend = w.bend * magnitude(T((end - first) / (1.0 - gamma_2) - (first - from) / gamma_2));
  return where(bend > change, bend, change);
}

// Converts the position error of a ball to an error of its load. This is used in bearings with a
// one-piece cage, whose pockets throw balls outside the loaded arc back and forth between the
// raceways. A position error changes the load in proportion to the stiffness of the contacts, but
// by no more than the load itself. `share` is the stiffness divided by the largest stiffness. The
// load varies as the cube of `share`; the largest load is `full` (m) times two thirds of the
// largest stiffness. The error of a free ball may be 200 times the error of a loaded ball.
static RACEWAY_INLINE Lane of_load(const Lane &share, const Lane &off, double full)
{
  const Lane by_stiffness = share * off, by_load = share * share * share * (full / 1.5),
             least = 0.005 * off;
  const Lane less = where(by_stiffness < by_load, by_stiffness, by_load);
  return where(less > least, less, least);
}

RACEWAY_LANES double BearingIntegrator::error(double h, const Settings &set) const
{
  const bool drift = set.dampers_only, one = set.order == 1;
  const double share = drift ? 1.0 : one ? 0.5 : gamma_2;
  const double full = drift ? 0.0 : light * largest_stiffness();
  const ErrorWeights weights =
      set.estimate ? ErrorWeights{sudden(set.relative), safe * bend_2 / gamma_2} : ErrorWeights();
  // m/s, velocity error equivalent to the largest overlap; 0 if there is no one-piece cage
  const double whole =
      drift || bodies_.model.cages.empty() ? 0.0 : forces_.largest_overlap() / (share * h);
  Lane off = {};
  for (const BodyGroup &g : bodies_.groups) {
    Lane counts = all_lanes(g.spins ? 1.0 : set.cage_error());
    if (g.spins && full > 0.0) {
      const Lane share_of_full = g.stiffness * (1.0 / full);
      counts = where(share_of_full < 1.0, share_of_full, 1.0);
      counts = where(counts < least_count, least_count, counts);
    }
    const Vec3L before = drift ? Vec3L() : one ? g.v_from : g.v_first;
    const Lane x = changed(weights, g.v_from.x, before.x, g.v.x),
               z = changed(weights, g.v_from.z, before.z, g.v.z), larger = where(x > z, x, z);
    Lane worse = larger * counts;
    if (whole > 0.0 && full > 0.0 && g.spins)
      worse = of_load(g.stiffness * (light / full), larger, whole);
    off = where(g.used & (worse > off), worse, off);
  }
  double largest = std::max(std::max(off[0], off[1]), std::max(off[2], off[3]));
  for (const Coordinate &c : bodies_.border) {
    const double before = drift ? 0.0 : one ? *c.from : *c.first;
    const double counts = c.of_cage ? set.cage_error() : 1.0;
    largest = std::max(largest,
                       counts * changed(weights, *c.from, before, *c.now) * c.moves(ball_radius()));
  }
  return share * h * largest;
}

// Adds the correction. Its size (m) is the largest displacement of balls (normal to the rolling
// direction), rings and shaft modes; the size for the cage is weighted and stored separately.
RACEWAY_LANES void BearingIntegrator::apply(double h, double cage_counts, Outcome &o)
{
  Lane off = {}, off_cage = {};
  bool finite = true;
  for (size_t k = 0; k < bodies_.groups.size(); ++k) {
    BodyGroup &g = bodies_.groups[k];
    const Vec3L dv = Vec3L::from(g.rhs);
    g.v += dv;
    const Lane all = magnitude(dv.x) + magnitude(dv.y) + magnitude(dv.z);
    const LaneMask bad = g.used & ~(all < HUGE_VAL);
    if (any(bad)) {
      finite = false;
      for (int i = 0; i < lanes; ++i)
        if (bad[i]) o.body = bodies_.body_at[lanes * k + i];
    }
    if (g.spins) g.w += Vec3L::from(g.rhs + 3);
    Lane &most = g.spins ? off : off_cage;
    const Lane worse = across(dv) * (g.spins ? 1.0 : cage_counts);
    most = where(g.used & (worse > most), worse, most);
  }
  double largest = std::max(std::max(off[0], off[1]), std::max(off[2], off[3]));
  double largest_cage =
      std::max(std::max(off_cage[0], off_cage[1]), std::max(off_cage[2], off_cage[3]));
  for (size_t k = 0; k < bodies_.border.size(); ++k) {
    const Coordinate &c = bodies_.border[k];
    const double dv = system_.y(k);
    *c.gained += dv;
    finite = finite && std::fabs(dv) < HUGE_VAL;
    double &most = c.of_cage ? largest_cage : largest;
    const double counts = c.of_cage ? cage_counts : 1.0;
    most = std::max(most, counts * std::fabs(dv) * c.moves(ball_radius()));
  }
  o.last = finite ? h * largest : HUGE_VAL;
  o.last_cage = finite ? h * largest_cage : HUGE_VAL;
}

// Undoes half of the last correction.
RACEWAY_LANES void BearingIntegrator::halve()
{
  for (BodyGroup &g : bodies_.groups) {
    for (Lane &one : g.rhs) one *= 0.5;
    g.v -= Vec3L::from(g.rhs);
    if (g.spins) g.w -= Vec3L::from(g.rhs + 3);
  }
  system_.halve();
  for (size_t k = 0; k < bodies_.border.size(); ++k) *bodies_.border[k].gained -= system_.y(k);
}

Failure BearingIntegrator::accept()
{
  const Failure failure = instants_.pass(present_.h, present_.s0, present_.s1);
  bodies_.accept();
  energy_.work += pending_.work;
  energy_.dissipated += pending_.dissipated - pending_.stored;
  return failure;
}

}    // namespace raceway
