// SPDX-License-Identifier: GPL-2.0-or-later
// Forces on a one-piece cage: contacts with the balls in its pockets, the film at the land that
// guides it, and churning at its faces.
#include "bearing_forces.h"
#include "bearing_system.h"

namespace raceway {

// Returns the velocity of a point at `lever` (m) from a ring's centre per unit of a degree of
// freedom.
static Vec3 motion_of(int dof, const Vec3 &e, const Vec3 &lever)
{
  switch (dof) {
    case 0: return {1.0, 0.0, 0.0};
    case 1: return {0.0, 1.0, 0.0};
    case 2: return {0.0, 0.0, 1.0};
    case RingProgram::TILT: return cross(Vec3{1.0, 0.0, 0.0}, lever);
    case RingProgram::TILT + 1: return cross(Vec3{0.0, 1.0, 0.0}, lever);
    default: return cross(e, lever);
  }
}

static CageMotion motion_of(const RingPose &r)
{
  return {r.x, r.v, r.e, r.angular_velocity(), r.angle};
}

void BearingForces::cages(const Stage &stage)
{
  auto number = b_.pocket_of.begin();
  for (const BearingModel::Cage &cage : b_.model.cages) {
    RingBody &ring = b_.rings[cage.ring];
    const CageMotion m = motion_of(ring.now);
    for (int body : cage.balls) pocket(stage, cage, m, body, *number++);
    if (cage.land >= 0) land(stage, cage, m);
    const double churning = cage.of->churning(ring.now.spin);
    ring.moment -= m.e * churning;
    power_lost_ += churning * ring.now.spin;
  }
}

// Evaluates the contact between a ball and its pocket in the ball's frame. Because of the spring
// and damper along the normal n, the force of the wall depends on the motion of the ball's centre.
// Because of friction, which acts across n, it also depends on the motion of the ball's surface at
// the wall, which is at -R n from the centre.
void BearingForces::pocket(const Stage &stage, const BearingModel::Cage &cage, const CageMotion &m,
                           int body, int number)
{
  const bool fresh = stage.evaluate == Evaluate::derivatives;
  RingBody &ring = b_.rings[cage.ring];
  const int at = b_.slot[body], group = at / lanes, i = at % lanes;
  BodyGroup &g = b_.groups[group];
  const double cosine = g.now.c[i], sine = g.now.s[i], R = g.radius[i], h = stage.h;
  const auto lab = [&](const Vec3L &a) -> Vec3 {
    return {a.x[i] * cosine - a.y[i] * sine, a.x[i] * sine + a.y[i] * cosine, a.z[i]};
  };
  const auto local = [&](const Vec3 &a) -> Vec3 {
    return {a.x * cosine + a.y * sine, a.y * cosine - a.x * sine, a.z};
  };
  const PocketBall ball = {Vec3{g.now.r[i] * cosine, g.now.r[i] * sine, g.now.z[i]} + b_.centre,
                           lab(g.v), lab(g.w), R, g.mass[i]};
  const PocketContact c = pocket_contact(*cage.of, m, number, ball, fresh ? stage.close_cage : 0.0,
                                         barely_touching, fresh);
  power_lost_ += c.loss;
  contact_energy_ += c.energy;
  ring.force -= c.force;
  ring.moment += c.cage_moment;
  const auto add = [i](Lane *to, const Vec3 &a) {
    to[0][i] += a.x;
    to[1][i] += a.y;
    to[2][i] += a.z;
  };
  add(g.rhs, local(c.force) * h);
  add(g.rhs + 3, local(c.ball_torque) * h);
  if (!fresh) return;
  if (cage.of->film.viscosity > 0.0) film_rows(stage, ring, m, c, at);
  if (!(c.h.growth > 0.0)) return;
  if (stage.dampers_only && c.h.force > 0.0) {
    // the ball and the cage vibrate on the same spring, which at most doubles its effect on either
    // of them
    g.spring[i] += 2.0 * c.h.stiffness;
    g.damper[i] += c.h.damping;
    ring.spring += 2.0 * c.h.stiffness;
  }
  const double springs = h * stage.follows(), along = h * c.h.damping + springs * c.h.growth,
               bend = springs * c.bend, across = h * c.braking;
  const Vec3 n = local(c.normal), wall = n * -R, pull = n - local(c.slide), side = local(c.side);
  // change in the force due to motions of the ball's centre and of its surface
  const auto answer = [&](const Vec3 &centre, const Vec3 &surface) -> Vec3 {
    const Vec3 f = pull * (along * dot(centre, n)) + (surface - n * dot(surface, n)) * across;
    return f +
           (c.spherical ? (centre - n * dot(centre, n)) * bend : side * (bend * dot(centre, side)));
  };
  Vec3 by_ball[6];    // change in the force per unit of the ball's velocity and spin
  const Vec3 unit[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  for (int k = 0; k < 3; ++k) {
    by_ball[k] = answer(unit[k], unit[k]);
    by_ball[3 + k] = cross(unit[k], wall) * across;
  }
  double force[6];
  const auto rows = [&](const Vec3 &f) {
    f.to(force);
    cross(wall, f).to(force + 3);
  };
  for (int k = 0; k < 6; ++k) {
    rows(by_ball[k]);
    for (int row = 0; row < 6; ++row) g.A[6 * row + k][i] += force[row];
  }
  g.coupled = g.coupled || ring.loose;
  int moving[RingProgram::N_DOF], count = 0;    // columns of the cage
  Vec3 surface[RingProgram::N_DOF];             // motions at the wall
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    if (ring.column[dof] < 0) continue;
    moving[count] = ring.column[dof];
    surface[count++] = local(motion_of(dof, m.e, c.lever - c.normal * R));
  }
  for (int dof = 0, k = 0; dof < RingProgram::N_DOF; ++dof) {
    if (ring.column[dof] < 0) continue;
    const Vec3 f = answer(local(motion_of(dof, m.e, c.lever)), surface[k]);
    rows(f);
    Lane *B = system_.B(group, moving[k]), *C = system_.C(group, moving[k]);
    for (int row = 0; row < 6; ++row) {
      B[row][i] -= force[row];
      C[row][i] -= dot(surface[k], by_ball[row]);
    }
    for (int o = 0; o < count; ++o) system_.D(moving[o], moving[k]) += dot(surface[o], f);
    ++k;
  }
}

// Adds the derivatives of the force of a squeeze film to the rows of a ball and its cage. The film
// answers a motion u of the ball's centre with both u + x (x_share.u) + v (v_share.u).
void BearingForces::film_rows(const Stage &stage, const RingBody &ring, const CageMotion &m,
                              const PocketContact &c, int slot)
{
  const int group = slot / lanes, i = slot % lanes;
  BodyGroup &g = b_.groups[group];
  const double cosine = g.now.c[i], sine = g.now.s[i], h = stage.h, springs = h * stage.follows();
  const auto local = [&](const Vec3 &a) -> Vec3 {
    return {a.x * cosine + a.y * sine, a.y * cosine - a.x * sine, a.z};
  };
  const PocketSqueeze &film = c.film;
  const Vec3 x = local(film.x), v = local(film.v), axis = c.spherical ? Vec3() : local(c.axis);
  const auto share = [&](const double *slope) -> Vec3 {
    return x * (2.0 * springs * slope[0] + h * slope[1]) +
           v * (springs * slope[1] + 2.0 * h * slope[2]);
  };
  const Vec3 x_share = share(film.spring), v_share = share(film.damper);
  const double both = springs * film.of.spring + h * film.of.damper;
  const auto add = [i](Lane *to, const Vec3 &a) {
    to[0][i] += a.x;
    to[1][i] += a.y;
    to[2][i] += a.z;
  };
  const Vec3 unit[] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  for (int k = 0; k < 3; ++k) {
    const Vec3 f = (unit[k] - axis * dot(axis, unit[k])) * both + x * dot(x_share, unit[k]) +
                   v * dot(v_share, unit[k]);
    for (int row = 0; row < 3; ++row) g.A[6 * row + k][i] += dot(f, unit[row]);
  }
  if (!ring.loose) return;
  g.coupled = true;
  Vec3 motion[RingProgram::N_DOF];
  int column[RingProgram::N_DOF], count = 0;
  for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
    if (ring.column[dof] < 0) continue;
    column[count] = ring.column[dof];
    motion[count++] = local(motion_of(dof, m.e, c.lever));
  }
  for (int k = 0; k < count; ++k) {
    const Vec3 &u = motion[k], across = (u - axis * dot(axis, u)) * both;
    const Vec3 f = across + x * dot(x_share, u) + v * dot(v_share, u);
    add(system_.B(group, column[k]), -f);
    add(system_.C(group, column[k]), -(across + x_share * dot(x, u) + v_share * dot(v, u)));
    for (int o = 0; o < count; ++o) system_.D(column[o], column[k]) += dot(motion[o], f);
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
      const Vec3 way = motion_of(dof, r->now.e, lever) * (r == &ring ? 1.0 : -1.0);
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
