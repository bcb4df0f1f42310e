// SPDX-License-Identifier: GPL-2.0-or-later
// The course of a step; forces and derivatives are in bearing_forces.cpp, the linear solve in
// bearing_solve.cpp.
#include "bearing_step.h"

#include <algorithm>

namespace raceway {

static const double gamma_2 = 1.0 - std::sqrt(0.5);     // length of a stage of order 2
static const double beyond_2 = 1.0 + std::sqrt(2.0);    // (1 - gamma)/gamma

BearingStep::BearingStep(const BearingModel &model) : model_(model)
{
  place_bodies();
  rings_.resize(model_.rings);
  touches_.resize([this] {
    size_t n = 0;
    for (const Track &t : tracks_) n += t.end - t.first;
    return n;
  }());
  chain_.resize(static_cast<int>(body_at_.size()));
  place_.resize(body_at_.size());
  in_pocket_.assign(groups_.size(), false);
  for (const BearingModel::Pocket &p : model_.pockets)
    for (int k : {p.a, p.b}) in_pocket_[slot_[k] / lanes] = true;
}

// Balls on the same raceways stand side by side, and so do cage balls on the same rails.
void BearingStep::place_bodies()
{
  using Key = std::vector<std::pair<int, const void *>>;
  std::vector<Key> key(model_.bodies.size());
  for (const BearingModel::Groove &g : model_.grooves) key[g.body].push_back({g.ring, g.physics});
  for (const BearingModel::Seat &s : model_.seats) key[s.body].push_back({s.ring, s.rails});
  std::vector<std::vector<int>>
      rows;    // in order of their first body: addresses must not order anything
  for (int k = 0; k < static_cast<int>(key.size()); ++k) {
    auto same = [&](const std::vector<int> &row) {
      return key[row[0]] == key[k] && model_.bodies[row[0]].spins == model_.bodies[k].spins;
    };
    auto row = std::find_if(rows.begin(), rows.end(), same);
    if (row == rows.end()) rows.push_back({k});
    else row->push_back(k);
  }
  slot_.assign(key.size(), -1);
  for (const std::vector<int> &row : rows) {
    const int first = static_cast<int>(groups_.size());
    const int n = static_cast<int>(row.size()), padded = (n + lanes - 1) / lanes * lanes;
    for (int i = 0; i < padded; ++i) {
      const int k = row[std::min(i, n - 1)];    // padding repeats the last body, without forces
      if (i % lanes == 0) {
        groups_.emplace_back();
        groups_.back().spins = model_.bodies[k].spins;
      }
      Group &g = groups_.back();
      const BearingModel::Body &b = model_.bodies[k];
      g.mass[i % lanes] = b.mass;
      g.inertia[i % lanes] = 0.4 * b.mass * b.radius * b.radius;
      g.radius[i % lanes] = b.radius;
      g.used[i % lanes] = i < n ? -1 : 0;
      if (i < n) slot_[k] = static_cast<int>(body_at_.size());
      body_at_.push_back(i < n ? k : -1);
    }
    const int end = static_cast<int>(groups_.size());
    for (const BearingModel::Groove &g : model_.grooves)
      if (g.body == row[0]) tracks_.push_back({g.ring, first, end, g.physics});
    for (const BearingModel::Seat &s : model_.seats)
      if (s.body == row[0]) rail_tracks_.push_back({s.ring, first, end, s.rails, s.stiffness});
  }
}

// Free degrees of freedom of the rings: the border. They do not change while a run lasts.
void BearingStep::find_unknowns()
{
  unknowns_known_ = true;
  free_.clear();
  for (size_t k = 0; k < rings_.size(); ++k) {
    rings_[k].loose = false;
    for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
      rings_[k].unknown[dof] = -1;
      if (!rings_[k].program.free(dof)) continue;
      rings_[k].loose = true;
      rings_[k].unknown[dof] = static_cast<int>(free_.size());
      free_.push_back({static_cast<int>(k), dof});
    }
  }
  const size_t nf = free_.size();
  B_.assign(groups_.size() * nf, Column());
  C_.assign(groups_.size() * nf, Column());
  border_.resize(static_cast<int>(nf));
  y_.assign(nf, 0.0);
}

void BearingStep::load(const std::vector<BodyPose> &bodies, const std::vector<RingPose> &rings)
{
  if (!unknowns_known_) find_unknowns();
  for (size_t k = 0; k < rings_.size(); ++k) rings_[k].from = rings[k];
  // balls circle the ring that is not free, the last one if there is a choice
  centre_ = rings_.front().from.x;
  for (const Ring &r : rings_)
    if (!r.program.free(0) && !r.program.free(1) && !r.program.free(2)) centre_ = r.from.x;
  int last = 0;
  for (size_t slot = 0; slot < body_at_.size(); ++slot) {
    if (body_at_[slot] >= 0) last = body_at_[slot];
    const BodyPose &b = bodies[last];
    Group &g = groups_[slot / lanes];
    const int i = static_cast<int>(slot % lanes);
    g.from.set(i, b.x - centre_);
    const double c = g.from.c[i], s = g.from.s[i];
    for (auto one : {std::make_pair(&g.v_from, b.v), std::make_pair(&g.w_from, b.w)}) {
      one.first->x[i] = one.second.x * c + one.second.y * s;
      one.first->y[i] = one.second.y * c - one.second.x * s;
      one.first->z[i] = one.second.z;
    }
  }
}

void BearingStep::store(std::vector<BodyPose> &bodies, std::vector<RingPose> &rings) const
{
  for (size_t k = 0; k < rings_.size(); ++k) rings[k] = rings_[k].from;
  for (size_t slot = 0; slot < body_at_.size(); ++slot) {
    if (body_at_[slot] < 0) continue;
    const Group &g = groups_[slot / lanes];
    const int i = static_cast<int>(slot % lanes);
    const Vec3L x = g.from.place(), v = g.from.lab(g.v_from), w = g.from.lab(g.w_from);
    BodyPose &b = bodies[body_at_[slot]];
    b.x = Vec3{x.x[i], x.y[i], x.z[i]} + centre_;
    b.v = {v.x[i], v.y[i], v.z[i]};
    if (g.spins) b.w = {w.x[i], w.y[i], w.z[i]};
  }
}

BearingStep::Outcome BearingStep::step(const Settings &set, double h, double s0, double s1)
{
  Outcome o;
  overlinked_ = worst_ = -1;
  pending_ = Energy();
  present_ = {h, s0, s1};
  for (Group &g : groups_) {
    g.base = g.from;
    g.turned = Lane{};
    g.v = g.v_base = g.v_from;
    g.w = g.w_base = g.w_from;
  }
  for (Ring &r : rings_) {
    r.base = r.from;
    std::fill(r.gained, r.gained + RingProgram::N_DOF, 0.0);
  }
  dampers_only_ = set.dampers_only;
  if (dampers_only_) {
    const double middle = 0.5 * (s0 + s1);
    if (!coast(0.5 * h, middle, false) || !solve_stage(set, h, middle, o)) return o;
    o.stability = stability(h);
    if (keep_energy_) add_energy(h, middle);
    if (!coast(0.5 * h, s1, true)) return o;
  } else if (set.order == 1) {
    if (!solve_stage(set, h, s1, o)) return o;
    if (keep_energy_) add_energy(h, s1);
  } else {
    const double stage = gamma_2 * h;
    if (!solve_stage(set, stage, s0 + gamma_2 * (s1 - s0), o)) return o;
    if (keep_energy_) add_energy((1.0 - gamma_2) * h, s0 + gamma_2 * (s1 - s0));
    second_base();
    if (!solve_stage(set, stage, s1, o)) return o;
    if (keep_energy_) add_energy(stage, s1);
  }
  o.error = error(h, set);
  o.solved = true;
  return o;
}

bool BearingStep::solve_stage(const Settings &set, double h, double s, Outcome &o)
{
  double before = HUGE_VAL;
  bool fresh = true;
  if (!move(h, s)) return false;
  for (int n = 1; n <= set.corrections; ++n) {
    start_rhs(h, fresh);
    if (!forces(h, fresh)) {
      if (fresh) return false;    // no numbers, or a ball far outside its groove
      fresh = true;               // other cage contacts than before
      start_rhs(h, fresh);
      if (!forces(h, fresh)) return false;
    }
    border_rhs(h, s);
    if (fresh) factor();
    solve();
    ++o.corrections;
    o.last = apply(h);
    if (!(o.last < HUGE_VAL)) return false;
    if (!move(h, s)) return false;
    if (o.last <= set.newton) return true;
    // derivatives of the last correction will do as long as each is a tenth of the one before
    fresh = !(o.last < 0.1 * before);
    before = o.last;
  }
  return set.corrections == 1;
}

// Everything to the end of the stage with the present velocities. False: a body turns too far for
// one stage.
RACEWAY_LANES bool BearingStep::move(double h, double s)
{
  if (dampers_only_) {
    for (Ring &r : rings_) r.now = kicked(r.program, r.base, r.gained);
    return true;
  }
  LaneMask far = {};
  for (Group &g : groups_) {
    g.now = g.base.drifted(g.v, h, g.turn);
    far |= ~(magnitude(g.turn) * beyond_2 <
             largest_turn);    // the base of a second stage goes that far
  }
  for (Ring &r : rings_) r.now = moved(r.program, r.base, r.gained, h, s);
  return !any(far);
}

// Everything on its way for h seconds, to the middle of a step or from there to its end. False: a
// body turns too far.
RACEWAY_LANES bool BearingStep::coast(double h, double s, bool to_end)
{
  LaneMask far = {};
  for (Group &g : groups_) {
    if (to_end) g.turned += g.turn;
    const LaneFrame start = to_end ? g.now : g.from;
    g.now = start.drifted(g.v, h, g.turn);
    far |= ~(magnitude(g.turn) < largest_turn);
  }
  for (Ring &r : rings_) r.base = r.now = coasted(r.program, to_end ? r.now : r.from, h, s);
  return !any(far);
}

RACEWAY_LANES double BearingStep::stability(double h) const
{
  Lane most = {};
  for (const Group &g : groups_) {
    const Lane share = h * h * g.spring / (3.0 * g.mass + 1.5 * h * g.damper);
    most = where(g.used & (share > most), share, most);
  }
  double largest = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
  for (const Ring &r : rings_)
    if (r.loose && r.program.mass > 0.0)
      largest = std::max(largest, h * h * r.spring / (3.0 * r.program.mass));
  return largest;
}

RACEWAY_LANES void BearingStep::second_base()
{
  for (Group &g : groups_) {
    g.v_first = g.v;
    g.base.r = g.from.r + beyond_2 * (g.now.r - g.from.r);
    g.base.z = g.from.z + beyond_2 * (g.now.z - g.from.z);
    g.turned = beyond_2 * g.turn;
    g.base.turn_from(g.from, g.turned);
    g.v_base = g.v_from + (g.v - g.v_from) * beyond_2;
    g.w_base = g.w_from + (g.w - g.w_from) * beyond_2;
  }
  for (Ring &r : rings_) {
    r.first = r.now;
    r.base = beyond(r.from, r.now, beyond_2);
    // first guess: the velocities of the first stage
    double base[3], first[3];
    r.base.v.to(base);
    r.first.v.to(first);
    for (int k = 0; k < 3; ++k) r.gained[k] = first[k] - base[k];
    for (int k = 0; k < 2; ++k) r.gained[RingProgram::TILT + k] = r.first.rate[k] - r.base.rate[k];
    r.gained[RingProgram::SPIN] = r.first.spin - r.base.spin;
  }
}

RACEWAY_LANES double BearingStep::error(double h, const Settings &set) const
{
  const bool drift = set.dampers_only, one = set.order == 1;
  const double share = drift ? 1.0 : one ? 0.5 : gamma_2;
  Lane off = {};
  for (const Group &g : groups_) {
    const Vec3L dv = drift ? g.v : g.v - (one ? g.v_from : g.v_first);
    const Lane worse = where(magnitude(dv.x) > magnitude(dv.z), magnitude(dv.x), magnitude(dv.z));
    off = where(g.used & (worse > off), worse, off);
  }
  double largest = std::max(std::max(off[0], off[1]), std::max(off[2], off[3]));
  for (const Free &f : free_) {
    if (f.dof == RingProgram::SPIN) continue;
    const Ring &r = rings_[f.ring];
    const RingPose before = drift ? RingPose() : one ? r.from : r.first;
    double now[3], then[3];
    r.now.v.to(now);
    before.v.to(then);
    const double dv =
        f.dof < RingProgram::TILT
            ? now[f.dof] - then[f.dof]
            : (r.now.rate[f.dof - RingProgram::TILT] - before.rate[f.dof - RingProgram::TILT]) *
                  groups_.front().now.r[0];
    largest = std::max(largest, std::fabs(dv));
  }
  return share * h * largest;
}

void BearingStep::accept()
{
  if (instants_.number > 1) look_at_instants();
  for (Group &g : groups_) {
    g.from = g.now;
    g.v_from = g.v;
    g.w_from = g.w;
  }
  for (Ring &r : rings_) r.from = r.now;
  energy_.work += pending_.work;
  energy_.dissipated += pending_.dissipated;
}

// What loads and drives put in and contacts took out at the end of a stage, times its weight in
// seconds.
void BearingStep::add_energy(double weight, double s)
{
  for (size_t k = 0; k < groups_.size(); ++k) groups_[k].rhs[0] = Lane{};
  forces(0.0, false);
  double power = 0.0;
  for (const Ring &r : rings_) {
    double push[3], pull[3], v[3], turn[3], contact[3];
    r.program.force_at(s).to(push);
    r.force.to(pull);
    r.now.v.to(v);
    r.program.moment_at(s).to(turn);
    r.moment.to(contact);
    for (int k = 0; k < 3; ++k) power += v[k] * (r.program.free(k) ? push[k] : -pull[k]);
    const Vec3 load = r.program.moment_at(s), W = r.now.across();
    const double w[3] = {W.x, W.y, r.now.spin};
    const double given[3] = {load.x, load.y, dot(load, r.now.e)};
    const double met[3] = {r.moment.x, r.moment.y, dot(r.moment, r.now.e)};
    for (int k = 0; k < 3; ++k)
      power += w[k] * (r.program.free(RingProgram::TILT + k) ? given[k] : -met[k]);
  }
  pending_.work += weight * power;
  pending_.dissipated += weight * power_lost_;
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
  for (Group &g : groups_) {
    g.now = g.from;
    g.v = g.v_from;
    g.w = g.w_from;
    Lane e = 0.5 * g.mass * dot(g.v, g.v);
    if (g.spins) e += 0.5 * g.inertia * dot(g.w, g.w);
    motion += where(g.used, e, 0.0);
  }
  double total = sum(motion);
  for (Ring &r : rings_) {
    r.now = r.from;
    double v[3];
    r.now.v.to(v);
    for (int k = 0; k < 3; ++k)
      if (r.program.free(k)) total += 0.5 * r.program.mass * v[k] * v[k];
    for (int k = 0; k < 2; ++k)
      if (r.program.free(RingProgram::TILT + k))
        total += 0.5 * r.program.inertia.transverse * r.now.rate[k] * r.now.rate[k];
    if (r.program.free(RingProgram::SPIN))
      total += 0.5 * r.program.inertia.axial * r.now.spin * r.now.spin;
  }
  forces(0.0, false);
  return total + contact_energy_;
}

}    // namespace raceway
