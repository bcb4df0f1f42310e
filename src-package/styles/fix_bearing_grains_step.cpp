// SPDX-License-Identifier: GPL-2.0-or-later
// Performs the step of fix bearing/grains. Each rank computes all contacts of the grains that it
// owns. A contact that is computed on two ranks is bitwise identical on both, because the grain
// with the lower tag comes first.
#include "../core/settings/arguments.h"
#include "../ranks/gather.h"
#include "fix_bearing_grains.h"
#include "fix_bearing_shaft.h"
#include "fixes.h"
#include "pair_bearing_hertz.h"

#include <algorithm>

using namespace LAMMPS_NS;
using raceway::GrainContact;
using raceway::Vec3;

void FixBearingGrains::find_neighbours()
{
  if (build_ == pair_->table_build()) return;
  build_ = pair_->table_build();
  neighbours_.clear();
  const int *mask = atom->mask, nlocal = atom->nlocal;
  for (const auto &p : pair_->grains()) {
    if (!(mask[p.first] & groupbit) || !(mask[p.second] & groupbit)) continue;
    if (p.first < nlocal) neighbours_.push_back({p.first, p.second});
    if (p.second < nlocal) neighbours_.push_back({p.second, p.first});
  }
  const bearing::tag_t *tag = atom->tag;
  std::sort(neighbours_.begin(), neighbours_.end(), [tag](const Neighbour &a, const Neighbour &b) {
    return tag[a.i] != tag[b.i] ? tag[a.i] < tag[b.i] : tag[a.j] < tag[b.j];
  });
}

void FixBearingGrains::find_shafts()
{
  for (Shaft &s : shafts_) {
    s.before = s.now;
    s.now = s.fix->pose();
  }
  for (Wall &wall : walls_) {
    const Shaft *s = wall.shaft < 0 ? nullptr : &shafts_[wall.shaft];
    wall.moved = velocity(s);
    wall.pose = s ? s->now : raceway::RingAtom();
    const Vec3 e = wall.pose.e, one = e.z > 0.5 ? Vec3{e.z, 0.0, -e.x} : Vec3{1.0, 0.0, 0.0};
    wall.e1 = one * (1.0 / norm(one));
    wall.e2 = cross(e, wall.e1);
  }
}

// Returns the mean velocity (m/s) and angular velocity (rad/s) of a shaft over the step. They are
// computed from the change in its position, so that the work done by its walls equals the work done
// by the shaft with either integrator. The bearing axis is the third component.
FixBearingGrains::Velocity FixBearingGrains::velocity(const Shaft *s) const
{
  if (!s) return {};
  const double per = 1.0 / update->dt;
  return {(s->now.x - s->before.x) * per,
          (cross(s->before.e, s->now.e) + s->now.e * (s->now.angle - s->before.angle)) * per};
}

const GrainContact *FixBearingGrains::kept(int i, bearing::tag_t tag, int part) const
{
  for (const Contact &c : grains_[i].contacts)
    if (c.tag == tag && c.part == part) return &c.of;
  return nullptr;
}

bool FixBearingGrains::touched_a_wall(int i) const
{
  for (const Contact &c : grains_[i].contacts)
    if (c.tag == 0) return true;
  return false;
}

void FixBearingGrains::touch_grains(const Neighbour &p, double dt, std::vector<Contact> &list,
                                    double &lost, Vec3 &force, Vec3 &torque) const
{
  const bool first = atom->tag[p.i] < atom->tag[p.j];
  const int a = first ? p.i : p.j, b = first ? p.j : p.i;
  const Vec3 d = Vec3::from(atom->x[a]) - Vec3::from(atom->x[b]);
  const double reach = atom->radius[a] + atom->radius[b], far2 = dot(d, d);
  const GrainContact *before = kept(p.i, atom->tag[p.j], 0);
  if (far2 >= reach * reach && !before) return;
  Contact c = {atom->tag[p.j], 0, before ? *before : GrainContact()};
  const double far = std::sqrt(far2), overlap = reach - far;
  const Vec3 n = d * (1.0 / far);
  const double lever_a = atom->radius[a] - 0.5 * overlap, lever_b = atom->radius[b] - 0.5 * overlap;
  const Vec3 turn = Vec3::from(atom->omega[a]) * lever_a + Vec3::from(atom->omega[b]) * lever_b;
  const double m = atom->rmass[a] * atom->rmass[b] / (atom->rmass[a] + atom->rmass[b]);
  const raceway::GrainLaw &law = *pair_->coefficients().grains(atom->type[a], atom->type[b]);
  const Vec3 v = Vec3::from(atom->v[a]) - Vec3::from(atom->v[b]);
  lost += 0.5 * raceway::advance(c.of, law, {m, overlap, n, v, turn, {}, {}}, dt);
  if (!(overlap > 0.0)) return;
  list.push_back(c);
  if (first) force += c.of.force;
  else force -= c.of.force;
  torque -= c.of.couple * (first ? lever_a : lever_b);
}

void FixBearingGrains::touch_walls(int i, double dt, std::vector<Contact> &list, double &lost,
                                   Vec3 &force, Vec3 &torque)
{
  const double R = atom->radius[i];
  const Vec3 at = axes_.third(Vec3::from(atom->x[i])), v = axes_.third(Vec3::from(atom->v[i])),
             w = axes_.third(Vec3::from(atom->omega[i]));
  const bool touched = touched_a_wall(i);
  Vec3 push, couple;
  for (const Wall &wall : walls_) {
    const Vec3 &e = wall.pose.e, &e1 = wall.e1, &e2 = wall.e2, d = at - wall.pose.x;
    const Vec3 p = {dot(d, e1), dot(d, e2), dot(d, e) + wall.pose.origin.z};
    if (wall.shape.lost(p))
      BRG_ONE(bearing::name_of(*this) + ": grain " + std::to_string(atom->tag[i]) +
              " is beyond the walls of the drum at step " + std::to_string(update->ntimestep) +
              ": the walls are too soft, the step is too large, or the grain was placed outside");
    if (!touched && !wall.shape.near(p, R)) continue;
    for (int k = 0; k < wall.shape.parts(); ++k) {
      const raceway::WallTouch t = wall.shape.touch(k, p, R, wall.pose.angle);
      const GrainContact *before = touched ? kept(i, 0, wall.first + k) : nullptr;
      if (!(t.overlap > 0.0) && !before) continue;
      Contact c = {0, wall.first + k, before ? *before : GrainContact()};
      const Vec3 n = e1 * t.n.x + e2 * t.n.y + e * t.n.z;
      const double lever = R - std::max(0.0, t.overlap);
      const Vec3 arm = d - n * lever, force_0 = c.of.force, moment_0 = c.of.moment;
      lost += raceway::advance(
          c.of, wall_law_,
          {atom->rmass[i], t.overlap, n, v - wall.moved.v, w * lever, arm, wall.moved.w}, dt);
      const double power =
          dot(force_0 + c.of.force, wall.moved.v) + dot(moment_0 + c.of.moment, wall.moved.w);
      if (wall.shaft >= 0)
        pushes_.push_back(
            {atom->tag[i], c.part, wall.shaft, -c.of.force, -c.of.moment, 0.5 * dt * power});
      if (!(t.overlap > 0.0)) continue;
      list.push_back(c);
      push += c.of.force;
      couple -= c.of.couple * lever;
    }
  }
  force += axes_.lab(push);
  torque += axes_.lab(couple);
}

// Adds the forces of all contacts. If `advance` is false, as at the start of a run, the states of
// the contacts do not change.
void FixBearingGrains::act(bool advance)
{
  find_neighbours();
  find_shafts();
  pushes_.clear();
  const double dt = advance ? update->dt : 0.0;
  size_t next = 0;
  std::vector<int> order;
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & groupbit) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [this](int a, int b) { return atom->tag[a] < atom->tag[b]; });
  const bool keep = advance || !known_;
  for (const int i : order) {
    std::vector<Contact> list;
    double lost = 0.0;
    Vec3 force, torque;
    for (; next < neighbours_.size() && neighbours_[next].i == i; ++next)
      touch_grains(neighbours_[next], dt, list, lost, force, torque);
    if (!walls_.empty()) touch_walls(i, dt, list, lost, force, torque);
    force.add_to(atom->f[i]);
    torque.add_to(atom->torque[i]);
    if (!keep) continue;
    if (list.size() > most_contacts)
      BRG_ONE(bearing::name_of(*this) + ": grain " + std::to_string(atom->tag[i]) + " has " +
              std::to_string(list.size()) + " contacts, but at most " +
              std::to_string(most_contacts) + " are possible");
    grains_[i].contacts.swap(list);
    if (advance) grains_[i].lost += lost;
  }
  if (keep) load_shafts();
  for (Shaft &s : shafts_) s.fix->set_grain_load(s.force, s.moment);
}

void FixBearingGrains::load_shafts()
{
  if (shafts_.empty()) return;
  std::vector<Push> all = bearing::gather_all(pushes_, world);
  std::sort(all.begin(), all.end(), [](const Push &a, const Push &b) {
    return a.tag != b.tag ? a.tag < b.tag : a.part < b.part;
  });
  for (Shaft &s : shafts_) s.force = s.moment = Vec3();
  for (const Push &p : all) {
    shafts_[p.shaft].force += p.force;
    shafts_[p.shaft].moment += p.moment;
    work_ += p.work;
  }
}

void FixBearingGrains::setup(int)
{
  known_ = known_ && pair_->state()->time_continues();
  if (!known_)
    for (Shaft &s : shafts_) s.now = s.fix->pose();
  for (Grain &g : grains_) g.lost = 0.0;
  work_ = 0.0;
  act(false);
  known_ = true;
  start_ = sums();
  summed_ = -1;
}

void FixBearingGrains::post_force(int)
{
  act(true);
  known_ = true;
}
