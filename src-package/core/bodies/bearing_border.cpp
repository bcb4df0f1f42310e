// SPDX-License-Identifier: GPL-2.0-or-later
// Coordinates of rings and shafts, the couplings between them and the forces on them.
#include "bearing_bodies.h"

#include <algorithm>
#include <set>

namespace raceway {

void BearingBodies::add_freedoms(RingBody &r)
{
  r.loose = false;
  std::fill(r.coordinate, r.coordinate + RingProgram::N_DOF, -1);
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    if (!r.program.free(dof)) continue;
    r.loose = true;
    r.coordinate[dof] = static_cast<int>(border.size());
    Coordinate c = {r.program.inertia_at(dof), &r.gained[dof],        r.from.speed_of(dof),
                    r.base.speed_of(dof),      r.first.speed_of(dof), r.now.speed_of(dof)};
    c.tilts = dof == RingProgram::TILT || dof == RingProgram::TILT + 1;
    if (c.tilts) c.lever = r.span;
    if (dof == RingProgram::SPIN) c.lever = r.pockets;
    c.of_cage = r.pockets > 0.0;
    border.push_back(c);
  }
  std::copy(r.coordinate, r.coordinate + RingProgram::N_DOF, r.column);
}

void BearingBodies::add_modes(ShaftBend &b)
{
  b.mode = static_cast<int>(border.size());
  for (int k = 0; k < b.size(); ++k) {
    const int mode = k % b.modes->size();
    Coordinate c = {&b.modes->mass[mode], &b.gained[k],     &b.from.rate[k],
                    &b.base.rate[k],      &b.first.rate[k], &b.now.rate[k]};
    c.spring = b.modes->stiffness[mode];
    c.damper = b.modes->damping[mode];
    c.place = &b.now.place[k];
    border.push_back(c);
  }
}

// The set of coordinates does not change during a run.
void BearingBodies::find_border()
{
  border.clear();
  for (RingBody &r : rings)
    if (r.bend < 0) add_freedoms(r);
  columns = straight = static_cast<int>(border.size());
  for (const ShaftBend &b : bends) add_freedoms(rings[b.shaft]);
  for (ShaftBend &b : bends) {
    add_modes(b);
    for (ShaftBend::Seat &seat : b.seats) {
      RingBody &r = rings[seat.ring];
      seat.column = columns;
      r.loose = true;
      for (int &column : r.column) column = columns++;
    }
  }
  for (const Carried &c : on_shafts) {
    const RingBody &shaft = rings[c.shaft];
    RingBody &r = rings[c.ring];
    r.loose = shaft.loose;
    std::copy(shaft.coordinate, shaft.coordinate + RingProgram::N_DOF, r.coordinate);
    std::copy(shaft.column, shaft.column + RingProgram::N_DOF, r.column);
  }
  find_couplings();
  find_columns();
  if (!bends.empty()) find_coupled_columns();
}

// The supports of a flexible shaft act at its centre, which moves with the shaft and its modes.
void BearingBodies::find_couplings()
{
  couplings.clear();
  const auto add = [this](const RingBody &r, int dof) -> Coupling * {
    const int own = r.coordinate[dof];
    if (r.carried || !r.program.supported || own < 0) return nullptr;
    couplings.push_back({&r.program.support[dof], own, {{own, 1.0}}});
    return &couplings.back();
  };
  for (const RingBody &r : rings)
    for (int dof = 0; r.bend < 0 && dof < RingProgram::SPIN; ++dof) {
      Coupling *by = add(r, dof);
      const int other = !by || r.holder < 0 ? -1 : rings[r.holder].coordinate[dof];
      if (other >= 0) by->of.push_back({other, -1.0});
    }
  for (const ShaftBend &b : bends)
    for (int dof = 0; dof < RingProgram::SPIN; ++dof) {
      Coupling *by = add(rings[b.shaft], dof);
      if (!by) continue;
      by->after = b.mode + b.size() - 1;
      if (dof == 2) continue;    // modes cause no motion along the shaft
      const int n = b.modes->size(), tilt = RingProgram::TILT;
      const int first = b.mode + (dof == 0 || dof == tilt + 1 ? 0 : n);
      // a tilt about the first axis has the opposite sign of the slope in the second plane
      const double sign = dof == tilt ? -1.0 : 1.0;
      for (int k = 0; k < n; ++k)
        by->of.push_back(
            {first + k, sign * (dof < tilt ? b.centre->moved[k] : b.centre->tilted[k])});
    }
}

// Finds the columns of each group.
void BearingBodies::find_columns()
{
  const int n = static_cast<int>(groups.size());
  std::vector<std::set<int>> by_raceways(n), by_cages(n), connected(n);    // rings
  const auto touch = [this](std::vector<std::set<int>> &by, int ring, int first, int end) {
    for (const Carried &c : on_shafts)
      if (c.ring == ring) ring = c.shaft;
    for (int g = first; g < end; ++g) by[g].insert(ring);
  };
  for (const Track &t : tracks) touch(by_raceways, t.ring, t.first, t.end);
  for (const RailTrack &t : rail_tracks) touch(by_cages, t.ring, t.first, t.end);
  for (const BearingModel::Cage &c : model.cages)
    for (int ball : c.balls) by_cages[slot[ball] / lanes].insert(c.ring);
  std::vector<int> chain(n);
  for (int g = 0; g < n; ++g) chain[g] = g;
  for (const BearingModel::Pocket &p : model.pockets) {
    const int from = chain[slot[p.a] / lanes], to = chain[slot[p.b] / lanes];
    std::replace(chain.begin(), chain.end(), from, to);
  }
  for (int g = 0; g < n; ++g) {
    connected[chain[g]].insert(by_raceways[g].begin(), by_raceways[g].end());
    connected[chain[g]].insert(by_cages[g].begin(), by_cages[g].end());
  }
  const auto columns_of = [this](const std::set<int> &all) {
    std::vector<int> found;
    for (int ring : all)
      for (int column : rings[ring].column)
        if (column >= 0) found.push_back(column);
    return found;
  };
  columns_of_group.clear();
  for (int g = 0; g < n; ++g)
    columns_of_group.push_back(
        {columns_of(by_raceways[g]), columns_of(by_cages[g]), columns_of(connected[chain[g]])});
}

// With flexible shafts, finds the columns that can be coupled to each column: those of rings that
// are connected by bodies, lands or shafts.
void BearingBodies::find_coupled_columns()
{
  const int n = static_cast<int>(rings.size());
  std::vector<int> part(n + groups.size());
  for (size_t k = 0; k < part.size(); ++k) part[k] = static_cast<int>(k);
  const auto join = [&part](int a, int b) {
    std::replace(part.begin(), part.end(), int(part[a]), int(part[b]));
  };
  for (const Track &t : tracks)
    for (int g = t.first; g < t.end; ++g) join(t.ring, n + g);
  for (const RailTrack &t : rail_tracks)
    for (int g = t.first; g < t.end; ++g) join(t.ring, n + g);
  for (const BearingModel::Cage &c : model.cages)
    for (int ball : c.balls) join(c.ring, n + slot[ball] / lanes);
  for (const BearingModel::Pocket &p : model.pockets)
    join(n + slot[p.a] / lanes, n + slot[p.b] / lanes);
  for (const Carried &c : on_shafts) join(c.ring, c.shaft);
  std::vector<std::vector<int>> of_part(part.size());
  columns_of_column.assign(columns, {});
  for (int pass = 0; pass < 2; ++pass)
    for (int k = 0; k < n; ++k) {
      if (rings[k].levered || rings[k].bend >= 0) continue;    // it uses columns of its shaft
      for (int column : rings[k].column) {
        if (column < 0) continue;
        if (pass == 0) of_part[part[k]].push_back(column);
        else columns_of_column[column] = of_part[part[k]];
      }
    }
}

void BearingBodies::border_forces(double s, std::vector<double> &forces)
{
  for (const RingBody &r : rings) {
    if (!r.loose || r.carried) continue;
    const int *to = r.coordinate, tilt = RingProgram::TILT, spin = RingProgram::SPIN;
    const Vec3 &e = r.now.e;
    if (to[0] >= 0 || to[1] >= 0 || to[2] >= 0) {
      double push[3];
      force_on(r, s).to(push);
      for (int k = 0; k < 3; ++k)
        if (to[k] >= 0) forces[to[k]] = push[k];
    }
    if (to[tilt] >= 0 || to[tilt + 1] >= 0) {
      const Vec3 M = moment_on(r, s), turn = cross(r.now.across(), e);
      const double along = dot(M, e), momentum = r.program.inertia.axial * r.now.spin;
      if (to[tilt] >= 0) forces[to[tilt]] = M.x - along * e.x - momentum * turn.x;
      if (to[tilt + 1] >= 0) forces[to[tilt + 1]] = M.y - along * e.y - momentum * turn.y;
    }
    if (to[spin] >= 0)    // supports act on tilts only
      forces[to[spin]] = dot(r.moment + r.program.moment_at(s, r.now), e);
  }
  for (ShaftBend &b : bends) {
    const RingBody &shaft = rings[b.shaft];
    const std::vector<double> &of = b.forces(shaft.program, shaft.now, s);
    std::copy(of.begin(), of.end(), forces.begin() + b.mode);
  }
}

void BearingBodies::border_loads(double s, std::vector<double> &loads)
{
  for (const RingBody &r : rings) {
    if (!r.loose || r.carried) continue;
    Vec3 push = r.program.force_at(s, r.now.angle);
    if (heavy) push += gravity * r.program.mass;
    const Vec3 M = r.program.moment_at(s, r.now);
    const double all[] = {push.x, push.y, push.z, M.x, M.y, dot(M, r.now.e)};
    for (int dof = 0; dof < RingProgram::N_DOF; ++dof)
      if (r.coordinate[dof] >= 0) loads[r.coordinate[dof]] = all[dof];
  }
  for (ShaftBend &b : bends) {
    const RingBody &shaft = rings[b.shaft];
    const std::vector<double> &of = b.loads(shaft.program, shaft.now, s);
    std::copy(of.begin(), of.end(), loads.begin() + b.mode);
  }
}

double BearingBodies::power_on_drives(const RingBody &r) const
{
  Vec3 F = r.force, M = r.moment;
  if (r.holds) add_held(r, &F, &M);
  const double all[] = {F.x, F.y, F.z, M.x, M.y, dot(M, r.now.e)};
  double power = 0.0;
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof)
    if (!r.program.free(dof)) power += all[dof] * *r.now.speed_of(dof);
  return power;
}

Vec3 BearingBodies::force_on(const RingBody &r, double s) const
{
  Vec3 push = r.force + r.program.force_at(s, r.now.angle);
  if (r.program.supported) push += r.program.support_force(held(r));
  if (r.holds) add_held(r, &push, nullptr);
  if (heavy) push += gravity * r.program.mass;
  return push;
}

Vec3 BearingBodies::moment_on(const RingBody &r, double s) const
{
  Vec3 M = r.moment + r.program.moment_at(s, r.now);
  if (r.program.supported) {
    const RingPose seen = held(r);
    M += r.program.support_moment(seen, seen.rate[0], seen.rate[1]);
  }
  if (r.holds) add_held(r, nullptr, &M);
  return M;
}

void BearingBodies::add_held(const RingBody &holder, Vec3 *force, Vec3 *moment) const
{
  for (const RingBody &r : rings) {
    if (r.holder < 0 || &rings[r.holder] != &holder) continue;
    const RingPose seen = held(r);
    if (force) *force -= r.program.support_force(seen);
    if (moment) *moment -= r.program.support_moment(seen, seen.rate[0], seen.rate[1]);
  }
}

}    // namespace raceway
