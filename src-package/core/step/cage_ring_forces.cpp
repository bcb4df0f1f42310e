// SPDX-License-Identifier: GPL-2.0-or-later
// Forces on a one-piece cage: oil and walls of its pockets, the film at the land that guides it,
// and churning at its faces.
#include "bearing_forces.h"
#include "bearing_system.h"

namespace raceway {

static CageMotion motion_of(const RingPose &r)
{
  return {r.x, r.v, r.e, r.angular_velocity(), r.angle};
}

static RACEWAY_INLINE Vec3 sum(const Vec3L &a) { return {sum(a.x), sum(a.y), sum(a.z)}; }

// Adds s a to three lanes.
static RACEWAY_INLINE void add(Lane *to, const Vec3L &a, const Lane &s)
{
  to[0] += s * a.x;
  to[1] += s * a.y;
  to[2] += s * a.z;
}

RACEWAY_LANES void BearingForces::cages(const Stage &stage)
{
  for (size_t k = 0; k < b_.model.cages.size(); ++k) {
    const BearingModel::Cage &cage = b_.model.cages[k];
    RingBody &ring = b_.rings[cage.ring];
    const CageMotion m = motion_of(ring.now);
    PocketSums sums;
    const double first = m.angle + cage.of->phase, cosine = std::cos(first), sine = std::sin(first);
    for (const BearingBodies::Cell &cell : b_.cells[k])
      pockets_of(stage, cage, m,
                 carried_across<Lane>(m.e, cosine * cell.cosine - sine * cell.sine,
                                      sine * cell.cosine + cosine * cell.sine),
                 cell, sums);
    ring.force -= sum(sums.force);
    ring.moment += sum(sums.moment);
    power_lost_ += sum(sums.loss);
    for (int i = 0; i < sums.columns; ++i)
      for (int o = 0; o < sums.columns; ++o)
        system_.D(sums.column[o], sums.column[i]) += sum(sums.corner[o][i]);
    if (cage.land >= 0) land(stage, cage, m);
    const double churning = cage.of->churning(ring.now.spin);
    ring.moment -= m.e * churning;
    power_lost_ += churning * ring.now.spin;
  }
}

// All vectors are in the frames of the balls.
RACEWAY_INLINE void BearingForces::pockets_of(const Stage &stage, const BearingModel::Cage &cage,
                                              const CageMotion &m, const Vec3L &axis,
                                              const BearingBodies::Cell &cell, PocketSums &sums)
{
  const bool fresh = stage.evaluate == Evaluate::derivatives;
  BodyGroup &g = b_.groups[cell.group];
  const LaneFrame &f = g.now;
  const Lane none = {};
  const CageAxesT<Lane> axes = {
      {f.c, -f.s, none}, {f.s, f.c, none}, {none, none, all_lanes(1.0)}, f.local(m.e)};
  const Vec3L lever = Vec3L{f.r, none, f.z} - f.local(m.x - b_.centre), w = f.local(m.w);
  const PocketGapT<Lane> gap = pocket_gap(*cage.of, axes.e, f.local(axis), lever,
                                          g.v - f.local(m.v) - cross(w, lever), g.w - w);
  const PocketOilT<Lane> oil = pocket_oil(*cage.of, gap, fresh);
  const Lane h = where(cell.live, stage.h, 0.0);
  add(g.rhs, oil.force, h);
  add(g.rhs + 3, oil.ball_torque, h);
  const Lane share = where(cell.live, 1.0, 0.0);
  sums.force += f.lab(oil.force * share);
  sums.moment += f.lab(oil.cage_moment * share);
  sums.loss += oil.loss * share;
  if (fresh && cage.of->film.viscosity > 0.0) film_rows(stage, cage, cell, gap, oil, axes, sums);
  const double close = fresh ? stage.close_cage : 0.0;
  const LaneMask near = cell.live & (gap.overlap > -close);
  if (!any(near)) return;
  for (int i = 0; i < lanes; ++i) {
    if (!near[i]) continue;
    PocketGapT<double> one;
    one.axis = in_lane(gap.axis, i);
    one.lever = in_lane(gap.lever, i);
    one.velocity = in_lane(gap.velocity, i);
    one.spin = in_lane(gap.spin, i);
    one.apart = in_lane(gap.apart, i);
    one.around = gap.around[i];
    one.beyond = gap.beyond[i];
    one.distance = gap.distance[i];
    one.overlap = gap.overlap[i];
    const PocketWall p = pocket_wall(*cage.of, one, g.radius[i], g.mass[i], close, barely_touching);
    wall(stage, cage, one, p,
         {in_lane(axes.x, i), in_lane(axes.y, i), in_lane(axes.z, i), in_lane(axes.e, i)},
         cell.group, i);
  }
}

// Adds the derivatives of the forces of squeeze films to the rows of the balls and their cage. A
// film answers a motion u of the ball's centre with both u + x (x_share.u) + v (v_share.u).
RACEWAY_INLINE void BearingForces::film_rows(const Stage &stage, const BearingModel::Cage &cage,
                                             const BearingBodies::Cell &cell,
                                             const PocketGapT<Lane> &gap,
                                             const PocketOilT<Lane> &oil,
                                             const CageAxesT<Lane> &axes, PocketSums &sums)
{
  const RingBody &ring = b_.rings[cage.ring];
  BodyGroup &g = b_.groups[cell.group];
  const Lane h = where(cell.live, stage.h, 0.0), springs = h * stage.follows();
  const Lane both = springs * oil.film.spring + h * oil.film.damper;
  const Vec3L &x = gap.apart, &v = oil.velocity;
  const Vec3L x_share = x * (2.0 * springs * oil.spring[0] + h * oil.spring[1]) +
                        v * (springs * oil.spring[1] + 2.0 * h * oil.spring[2]),
              v_share = x * (2.0 * springs * oil.damper[0] + h * oil.damper[1]) +
                        v * (springs * oil.damper[1] + 2.0 * h * oil.damper[2]);
  // in a cylindrical pocket, the film does not resist motions along the axis
  const Vec3L axis = gap.axis * (cage.of->spherical ? 0.0 : 1.0);
  Lane of_axis[3], of_x[3], of_v[3], by_x[3], by_v[3];
  axis.to(of_axis);
  x.to(of_x);
  v.to(of_v);
  x_share.to(by_x);
  v_share.to(by_v);
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 3; ++k) {
      Lane f = of_x[row] * by_x[k] + of_v[row] * by_v[k] - both * of_axis[row] * of_axis[k];
      if (row == k) f += both;
      g.A[6 * row + k] += f;
    }
  if (!ring.loose) return;
  g.coupled = true;
  Vec3L motion[RingProgram::N_DOF];
  int count = 0;
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    if (ring.column[dof] < 0) continue;
    sums.column[count] = ring.column[dof];
    motion[count++] = axes.motion(dof, gap.lever);
  }
  sums.columns = count;
  const Lane minus = all_lanes(-1.0);
  for (int k = 0; k < count; ++k) {
    const Vec3L &u = motion[k], across = (u - axis * dot(axis, u)) * both;
    const Vec3L f = across + x * dot(x_share, u) + v * dot(v_share, u);
    add(system_.B(cell.group, sums.column[k]), f, minus);
    add(system_.C(cell.group, sums.column[k]), across + x_share * dot(x, u) + v_share * dot(v, u),
        minus);
    for (int o = 0; o < count; ++o) sums.corner[o][k] += dot(motion[o], f);
  }
}

// Adds the force of a wall and its derivatives. Because of the spring and damper along the normal
// n, the force depends on the motion of the ball's centre. Because of friction, which acts across
// n, it also depends on the motion of the ball's surface at the wall, which is at -R n from the
// centre.
void BearingForces::wall(const Stage &stage, const BearingModel::Cage &cage,
                         const PocketGapT<double> &gap, const PocketWall &c,
                         const CageAxesT<double> &axes, int group, int i)
{
  RingBody &ring = b_.rings[cage.ring];
  BodyGroup &g = b_.groups[group];
  const double R = g.radius[i], h = stage.h;
  const auto lab = [&](const Vec3 &a) -> Vec3 {
    return {dot(axes.x, a), dot(axes.y, a), dot(axes.z, a)};
  };
  power_lost_ += c.loss;
  contact_energy_ += c.energy;
  ring.force -= lab(c.force);
  ring.moment += lab(c.cage_moment);
  const auto push = [&](Lane *to, const Vec3 &a) {
    to[0][i] += h * a.x;
    to[1][i] += h * a.y;
    to[2][i] += h * a.z;
  };
  push(g.rhs, c.force);
  push(g.rhs + 3, c.ball_torque);
  if (stage.evaluate != Evaluate::derivatives || !(c.h.growth > 0.0)) return;
  if (stage.dampers_only && c.h.force > 0.0) {
    // the ball and the cage vibrate on the same spring, which at most doubles its effect on either
    // of them
    g.spring[i] += 2.0 * c.h.stiffness;
    g.damper[i] += c.h.damping;
    ring.spring += 2.0 * c.h.stiffness;
  }
  const double springs = h * stage.follows(), along = h * c.h.damping + springs * c.h.growth,
               bend = springs * c.bend, across = h * c.braking;
  const Vec3 &n = c.normal, at = n * -R, pull = n - c.slide;
  // change in the force due to motions of the ball's centre and of its surface
  const auto answer = [&](const Vec3 &centre, const Vec3 &surface) -> Vec3 {
    const Vec3 f = pull * (along * dot(centre, n)) + (surface - n * dot(surface, n)) * across;
    return f + (cage.of->spherical ? (centre - n * dot(centre, n)) * bend
                                   : c.side * (bend * dot(centre, c.side)));
  };
  Vec3 by_ball[6];    // change in the force per unit of the ball's velocity and spin
  const Vec3 unit[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  for (int k = 0; k < 3; ++k) {
    by_ball[k] = answer(unit[k], unit[k]);
    by_ball[3 + k] = cross(unit[k], at) * across;
  }
  double force[6];
  const auto rows = [&](const Vec3 &f) {
    f.to(force);
    cross(at, f).to(force + 3);
  };
  for (int k = 0; k < 6; ++k) {
    rows(by_ball[k]);
    for (int row = 0; row < 6; ++row) g.A[6 * row + k][i] += force[row];
  }
  g.coupled = g.coupled || ring.loose;
  int moving[RingProgram::N_DOF], count = 0;    // columns of the cage
  Vec3 centre[RingProgram::N_DOF], surface[RingProgram::N_DOF];
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    if (ring.column[dof] < 0) continue;
    moving[count] = ring.column[dof];
    centre[count] = axes.motion(dof, gap.lever);
    surface[count++] = axes.motion(dof, gap.lever + at);
  }
  for (int k = 0; k < count; ++k) {
    const Vec3 f = answer(centre[k], surface[k]);
    rows(f);
    Lane *B = system_.B(group, moving[k]), *C = system_.C(group, moving[k]);
    for (int row = 0; row < 6; ++row) {
      B[row][i] -= force[row];
      C[row][i] -= dot(surface[k], by_ball[row]);
    }
    for (int o = 0; o < count; ++o) system_.D(moving[o], moving[k]) += dot(surface[o], f);
  }
}

void BearingForces::land(const Stage &stage, const BearingModel::Cage &cage, const CageMotion &m)
{
  RingBody &ring = b_.rings[cage.ring], &guide = b_.rings[cage.land];
  const LandContact c = land_contact(*cage.of, m, motion_of(guide.now));
  power_lost_ += c.loss;
  contact_energy_ += c.energy;
  ring.force += c.force;
  ring.moment += c.moment;
  guide.force -= c.force;
  guide.moment -= c.moment + cross(c.lever, c.force);
  if (stage.evaluate != Evaluate::derivatives) return;
  if (stage.dampers_only) {
    ring.spring += 2.0 * c.stiffness;
    guide.spring += 2.0 * c.stiffness;
  }
  // motion of the cage relative to the ring along both axes, for each column
  struct Moving {
    int column;
    double along[2];
  };
  std::vector<Moving> moving;
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof)
    for (const RingBody *r : {&ring, &guide}) {
      if (r->column[dof] < 0 || !r->loose) continue;
      const Vec3 lever = r == &ring      ? Vec3()
                         : guide.levered ? c.lever + guide.now.e * guide.at
                                         : c.lever;
      const CageAxesT<double> axes = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, r->now.e};
      const Vec3 way = axes.motion(dof, lever) * (r == &ring ? 1.0 : -1.0);
      moving.push_back({r->column[dof], {dot(way, c.axis[0]), dot(way, c.axis[1])}});
    }
  const double springs = stage.h * stage.follows();
  for (const Moving &row : moving)
    for (const Moving &column : moving)
      for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k)
          system_.D(row.column, column.column) +=
              row.along[i] * (stage.h * c.moved[i][k] + springs * c.displaced[i][k]) *
              column.along[k];
}

}    // namespace raceway
