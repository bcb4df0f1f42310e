// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_bodies.h"

#include "shaft_ring.h"

#include <algorithm>

namespace raceway {

BearingBodies::BearingBodies(const BearingModel &of) : model(of)
{
  place();
  rings.resize(model.rings.size() + model.shafts.size());
  place_shafts();
  for (size_t k = 0; k < model.rings.size(); ++k) {
    rings[k].empty = std::none_of(tracks.begin(), tracks.end(),
                                  [k](const Track &t) { return t.ring == static_cast<int>(k); });
    rings[k].holder = model.rings[k].holder;
    if (rings[k].holder >= 0) rings[rings[k].holder].holds = true;
  }
  for (const BearingModel::Cage &c : model.cages) rings[c.ring].pockets = c.of->pitch;
  find_ball_profiles();
  states_ = law_facts(model.parts).states;
  if (states_ > 0) {
    kept.resize(n_contacts);
    kept_slopes.resize(n_contacts);
  }
}

// Places balls on the same raceways next to each other, and cage balls on the same rails as well.
void BearingBodies::place()
{
  using Key = std::vector<std::pair<int, const void *>>;
  std::vector<Key> key(model.bodies.size());
  for (const BearingModel::Groove &g : model.grooves) key[g.body].push_back({g.ring, g.physics});
  for (const BearingModel::Seat &s : model.seats) key[s.body].push_back({s.ring, s.rails});
  // sorted by first body, because the order must not depend on addresses
  std::vector<std::vector<int>> rows;
  for (int k = 0; k < static_cast<int>(key.size()); ++k) {
    auto same = [&](const std::vector<int> &row) {
      return key[row[0]] == key[k] && model.bodies[row[0]].spins == model.bodies[k].spins;
    };
    auto row = std::find_if(rows.begin(), rows.end(), same);
    if (row == rows.end()) rows.push_back({k});
    else row->push_back(k);
  }
  slot.assign(key.size(), -1);
  for (const std::vector<int> &row : rows) {
    const int first = static_cast<int>(groups.size());
    const int n = static_cast<int>(row.size()), padded = (n + lanes - 1) / lanes * lanes;
    for (int i = 0; i < padded; ++i) {
      // padding lanes repeat the last body and exert no force
      const int k = row[std::min(i, n - 1)];
      if (i % lanes == 0) {
        groups.emplace_back();
        groups.back().spins = model.bodies[k].spins;
      }
      BodyGroup &g = groups.back();
      const BearingModel::Body &b = model.bodies[k];
      g.mass[i % lanes] = b.mass;
      g.inertia[i % lanes] = 0.4 * b.mass * b.radius * b.radius;
      g.radius[i % lanes] = b.radius;
      g.used[i % lanes] = i < n ? -1 : 0;
      if (i < n) slot[k] = static_cast<int>(body_at.size());
      body_at.push_back(i < n ? k : -1);
    }
    const int end = static_cast<int>(groups.size());
    for (const BearingModel::Groove &g : model.grooves)
      if (g.body == row[0]) tracks.push_back({g.ring, first, end, g.physics, g.profile});
    for (const BearingModel::Seat &s : model.seats)
      if (s.body == row[0]) rail_tracks.push_back({s.ring, first, end, s.rails, s.stiffness});
  }
  for (const Track &t : tracks) {
    n_contacts += t.end - t.first;
    flawed = flawed || t.profile;
  }
  groove_at.assign(lanes * n_contacts, -1);
  for (const BearingModel::Groove &g : model.grooves) {
    const int at = slot[g.body];
    int contact = 0;
    for (const Track &t : tracks) {
      if (t.ring == g.ring && t.physics == g.physics && at / lanes >= t.first && at / lanes < t.end)
        contact_at.push_back(lanes * (contact + at / lanes - t.first) + at % lanes);
      contact += t.end - t.first;
    }
  }
  for (size_t g = 0; g < contact_at.size(); ++g) groove_at[contact_at[g]] = static_cast<int>(g);
}

void BearingBodies::find_ball_profiles()
{
  const auto has = [](const BearingModel::Groove &g) { return g.ball != nullptr; };
  if (std::none_of(model.grooves.begin(), model.grooves.end(), has)) return;
  flawed = true;
  ball_profiles.resize(n_contacts);
  ball_rows.resize(n_contacts);
  turns_at.assign(groups.size(), -1);
  for (size_t k = 0; k < model.grooves.size(); ++k) {
    const BearingModel::Groove &g = model.grooves[k];
    if (!g.ball) continue;
    BallProfiles &p = ball_profiles[contact_at[k] / lanes];
    p.any = true;
    p.of[contact_at[k] % lanes] = g.ball;
    const int group = slot[g.body] / lanes;
    if (turns_at[group] >= 0) continue;
    turns_at[group] = static_cast<int>(turns.size());
    turns.emplace_back(group);
  }
}

void BearingBodies::place_shafts()
{
  for (size_t s = 0; s < model.shafts.size(); ++s) {
    const int shaft = static_cast<int>(model.rings.size() + s);
    const ShaftModes *modes = model.shafts[s].modes;
    if (modes) {
      rings[shaft].bend = static_cast<int>(bends.size());
      bends.emplace_back();
      ShaftBend &b = bends.back();
      b.modes = modes;
      b.centre = &modes->station(0.0);
      b.shaft = shaft;
      for (BendState *state : {&b.from, &b.base, &b.now, &b.first}) state->resize(modes->size());
      b.gained.assign(b.size(), 0.0);
      b.contacts.assign(b.size(), 0.0);
      for (int k : model.shafts[s].rings)
        b.seats.push_back({k, -1, model.rings[k].at, &modes->station(model.rings[k].at)});
    }
    for (int k : model.shafts[s].rings) {
      rings[k].carried = true;
      rings[k].levered = !modes;
      rings[k].at = model.rings[k].at;
      rings[shaft].span = std::max(rings[shaft].span, std::fabs(rings[k].at));
      if (!modes) on_shafts.push_back({k, shaft});
    }
  }
}

void BearingBodies::carry()
{
  for (const Carried &c : on_shafts) {
    RingBody &r = rings[c.ring];
    r.now = raceway::carried(rings[c.shaft].now, r.at, r.from.origin);
  }
  for (const ShaftBend &b : bends)
    for (const ShaftBend::Seat &seat : b.seats) {
      RingBody &r = rings[seat.ring];
      r.now = raceway::carried(rings[b.shaft].now, seat.at, r.from.origin,
                               Deflection(*seat.station, b.now));
    }
}

void BearingBodies::add_shafts()
{
  for (const Carried &c : on_shafts) {
    const RingBody &r = rings[c.ring];
    RingBody &shaft = rings[c.shaft];
    shaft.force += r.force;
    shaft.moment += moment_about_centre(shaft.now.e, r.at, r.force, r.moment);
  }
  for (ShaftBend &b : bends) {
    RingBody &shaft = rings[b.shaft];
    std::fill(b.contacts.begin(), b.contacts.end(), 0.0);
    for (const ShaftBend::Seat &seat : b.seats) {
      const RingBody &r = rings[seat.ring];
      shaft.force += r.force;
      shaft.moment += moment_about_centre(shaft.now.e, seat.at, r.now.e, r.force, r.moment);
      add_to_modes(*seat.station, r.now.e, r.force, r.moment, b.contacts);
    }
  }
}

void BearingBodies::load(const std::vector<BodyPose> &bodies, const std::vector<RingPose> &poses)
{
  if (columns_of_group.empty()) find_border();
  for (size_t k = 0; k < poses.size(); ++k) rings[k].from = poses[k];
  for (size_t s = 0; s < model.shafts.size(); ++s) {
    const RingBody &first = rings[model.shafts[s].rings.front()];
    rings[poses.size() + s].from = shaft_of(first.from, first.at);
  }
  for (const ShaftBend &b : bends) {
    const ShaftBend::Seat &first = b.seats.front();
    rings[b.shaft].from =
        shaft_of(rings[first.ring].from, first.at, Deflection(*first.station, b.from));
  }
  // balls orbit about the fixed ring, or about the last one if there are several
  bool found = false;
  for (const RingBody &r : rings) {
    if (r.empty) continue;
    const bool stays = !r.carried && !r.program.free(0) && !r.program.free(1) && !r.program.free(2);
    if (stays || !found) centre = r.from.x;
    found = true;
  }
  int last = 0;
  for (size_t at = 0; at < body_at.size(); ++at) {
    if (body_at[at] >= 0) last = body_at[at];
    const BodyPose &b = bodies[last];
    BodyGroup &g = groups[at / lanes];
    const int i = static_cast<int>(at % lanes);
    g.from.set(i, b.x - centre);
    const double c = g.from.c[i], s = g.from.s[i];
    for (auto one : {std::make_pair(&g.v_from, b.v), std::make_pair(&g.w_from, b.w)}) {
      one.first->x[i] = one.second.x * c + one.second.y * s;
      one.first->y[i] = one.second.y * c - one.second.x * s;
      one.first->z[i] = one.second.z;
    }
    if (!turns.empty() && turns_at[at / lanes] >= 0)
      turns[turns_at[at / lanes]].load(i, g.from, b.turn);
  }
  find_cells(bodies);
}

void BearingBodies::find_cells(const std::vector<BodyPose> &bodies)
{
  cells.clear();
  for (const BearingModel::Cage &c : model.cages) {
    const RingPose &cage = rings[c.ring].from;
    CageMotion m;
    m.e = cage.e;
    m.angle = cage.angle;
    cells.emplace_back();
    for (int ball : c.balls) {
      const int group = slot[ball] / lanes, i = slot[ball] % lanes;
      if (cells.back().empty() || cells.back().back().group != group)
        cells.back().push_back({all_lanes(1.0), Lane(), LaneMask(), group});
      Cell &cell = cells.back().back();
      const double azimuth = c.of->azimuth(pocket_at(*c.of, m, bodies[ball].x - cage.x));
      cell.cosine[i] = std::cos(azimuth);
      cell.sine[i] = std::sin(azimuth);
      cell.live[i] = -1;
    }
  }
}

void BearingBodies::store(std::vector<BodyPose> &bodies, std::vector<RingPose> &poses) const
{
  for (size_t k = 0; k < poses.size(); ++k) poses[k] = rings[k].from;
  for (size_t at = 0; at < body_at.size(); ++at) {
    if (body_at[at] < 0) continue;
    const BodyGroup &g = groups[at / lanes];
    const int i = static_cast<int>(at % lanes);
    const Vec3L x = g.from.place(), v = g.from.lab(g.v_from), w = g.from.lab(g.w_from);
    BodyPose &b = bodies[body_at[at]];
    b.x = in_lane(x, i) + centre;
    b.v = in_lane(v, i);
    if (g.spins) b.w = in_lane(w, i);
    if (!turns.empty() && turns_at[at / lanes] >= 0)
      b.turn = turns[turns_at[at / lanes]].stored(i, g.from);
  }
}

void BearingBodies::load_states(const double *values)
{
  for (size_t g = 0; g < contact_at.size(); ++g)
    for (int k = 0; k < states_; ++k) {
      States &s = kept[contact_at[g] / lanes];
      const int lane = contact_at[g] % lanes;
      s.from[k][lane] = s.now[k][lane] = values[g * states_ + k];
    }
}

void BearingBodies::store_states(double *values) const
{
  for (size_t g = 0; g < contact_at.size(); ++g)
    for (int k = 0; k < states_; ++k)
      values[g * states_ + k] = kept[contact_at[g] / lanes].from[k][contact_at[g] % lanes];
}

void BearingBodies::start()
{
  for (BodyGroup &g : groups) {
    g.base = g.from;
    g.turned = Lane{};
    g.v = g.v_base = g.v_from;
    g.w = g.w_base = g.w_from;
  }
  on_border([](auto &one) { one.start(); });
  for (Coordinate &c : border) *c.gained = 0.0;
  for (BallTurns &t : turns) t.start();
  for (States &s : kept) std::copy(s.from, s.from + states_, s.base);
}

RACEWAY_LANES void BearingBodies::second_base(double beyond)
{
  for (BodyGroup &g : groups) {
    g.v_first = g.v;
    g.base.r = g.from.r + beyond * (g.now.r - g.from.r);
    g.base.z = g.from.z + beyond * (g.now.z - g.from.z);
    g.turned = beyond * g.turn;
    g.base.turn_from(g.from, g.turned);
    g.v_base = g.v_from + (g.v - g.v_from) * beyond;
    g.w_base = g.w_from + (g.w - g.w_from) * beyond;
  }
  for (States &s : kept)
    for (int m = 0; m < states_; ++m) {
      s.first[m] = s.now[m];
      s.base[m] = s.from[m] + beyond * (s.now[m] - s.from[m]);
    }
  for (BallTurns &t : turns) t.second_base(beyond);
  on_border([beyond](auto &one) { one.second_base(beyond); });
  // initial guess: velocities at the end of the first stage
  for (Coordinate &c : border) *c.gained = *c.first - *c.base;
}

void BearingBodies::accept()
{
  for (BodyGroup &g : groups) {
    g.from = g.now;
    g.v_from = g.v;
    g.w_from = g.w;
  }
  on_border([](auto &one) { one.accept(); });
  for (BallTurns &t : turns) t.accept();
  for (States &s : kept) std::copy(s.now, s.now + states_, s.from);
  for (BalancedContact &c : balanced) c.from = c.now;
}

}    // namespace raceway
