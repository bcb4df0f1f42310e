// SPDX-License-Identifier: GPL-2.0-or-later
// A cage that is one ring: balls in its pockets, the land that guides it, churning of its faces.
#include "bearing_forces.h"
#include "bearing_system.h"

namespace raceway {

// Velocity of a point at `lever` (m) from a ring's centre per unit of a degree of freedom.
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
  for (const BearingModel::Cage &cage : b_.model.cages) {
    RingBody &ring = b_.rings[cage.ring];
    const CageMotion m = motion_of(ring.now);
    for (int body : cage.balls) pocket(stage, cage, m, body);
    if (cage.land >= 0) land(stage, cage, m);
    const double churning = cage.of->churning(ring.now.spin);
    ring.moment -= m.e * churning;
    power_lost_ += churning * ring.now.spin;
  }
}

// One term of the derivatives of a pocket's force: -a force (motion . velocity of the ball's point
// against the cage's). `surface`: that point is on the ball's surface, otherwise at its centre.
struct PocketTerm {
  double a;
  Vec3 force, motion;
  bool surface;
};

void BearingForces::pocket(const Stage &stage, const BearingModel::Cage &cage, const CageMotion &m,
                           int body)
{
  const bool fresh = stage.evaluate == Evaluate::derivatives;
  RingBody &ring = b_.rings[cage.ring];
  const int at = b_.slot[body], group = at / lanes, i = at % lanes;
  BodyGroup &g = b_.groups[group];
  const double cosine = g.now.c[i], sine = g.now.s[i];
  const auto lab = [&](const Vec3L &a) -> Vec3 {
    return {a.x[i] * cosine - a.y[i] * sine, a.x[i] * sine + a.y[i] * cosine, a.z[i]};
  };
  const auto local = [&](const Vec3 &a) -> Vec3 {
    return {a.x * cosine + a.y * sine, a.y * cosine - a.x * sine, a.z};
  };
  const PocketBall ball = {Vec3{g.now.r[i] * cosine, g.now.r[i] * sine, g.now.z[i]} + b_.centre,
                           lab(g.v), lab(g.w), g.radius[i], g.mass[i]};
  const PocketContact c = pocket_contact(*cage.of, m, pocket_at(*cage.of, m, ball.x - m.x), ball,
                                         fresh && stage.close_cage > 0.0 ? barely_touching : 0.0);
  power_lost_ += c.loss;
  contact_energy_ += c.energy;
  ring.force -= c.force;
  ring.moment += c.cage_moment;
  const double h = stage.h;
  const auto add = [i, h](Lane *to, const Vec3 &a) {
    to[0][i] += h * a.x;
    to[1][i] += h * a.y;
    to[2][i] += h * a.z;
  };
  add(g.rhs, local(c.force));
  add(g.rhs + 3, local(c.ball_torque));
  if (!fresh || !(c.overlap > -stage.close_cage) || !(c.h.growth > 0.0)) return;
  if (stage.dampers_only && c.h.force > 0.0) {
    // ball and cage vibrate on one spring: its share in either is at most twice its own
    g.spring[i] += 2.0 * c.h.stiffness;
    g.damper[i] += c.h.damping;
    ring.spring += 2.0 * c.h.stiffness;
  }
  const double springs = h * stage.follows();
  const Vec3 n = c.normal, wall = n * -ball.radius,
             other = cross(n, std::fabs(n.z) < 0.7 ? Vec3{0.0, 0.0, 1.0} : c.axis),
             first = other * (1.0 / norm(other)), second = cross(n, first);
  PocketTerm terms[5];
  int count = 0;
  terms[count++] = {h * c.h.damping + springs * c.h.growth, n - c.slide, n, false};
  if (c.bend > 0.0 && springs > 0.0) {
    if (c.spherical) {
      terms[count++] = {springs * c.bend, first, first, false};
      terms[count++] = {springs * c.bend, second, second, false};
    } else {
      terms[count++] = {springs * c.bend, c.side, c.side, false};
    }
  }
  if (c.braking > 0.0)
    for (const Vec3 &way : {first, second}) terms[count++] = {h * c.braking, way, way, true};
  g.coupled = g.coupled || ring.loose;
  for (int k = 0; k < count; ++k) {
    const PocketTerm &t = terms[k];
    // rows of the ball's velocity and spin
    double force[6], motion[6];
    local(t.force).to(force);
    local(cross(wall, t.force)).to(force + 3);
    local(t.motion).to(motion);
    (t.surface ? local(cross(wall, t.motion)) : Vec3()).to(motion + 3);
    for (int row = 0; row < 6; ++row)
      for (int column = 0; column < 6; ++column)
        g.A[6 * row + column][i] += t.a * force[row] * motion[column];
    double moves[RingProgram::N_DOF], pushes[RingProgram::N_DOF];
    for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
      if (ring.column[dof] < 0) continue;
      moves[dof] = t.a * dot(motion_of(dof, m.e, t.surface ? c.lever + wall : c.lever), t.motion);
      pushes[dof] = dot(motion_of(dof, m.e, c.lever + wall), t.force);
    }
    for (int dof = 0; dof < RingProgram::N_DOF; ++dof) {
      const int j = ring.column[dof];
      if (j < 0) continue;
      const double pushed = t.a * pushes[dof];
      Lane *B = system_.B(group, j), *C = system_.C(group, j);
      for (int row = 0; row < 6; ++row) {
        B[row][i] -= moves[dof] * force[row];
        C[row][i] -= pushed * motion[row];
      }
      for (int o = 0; o < RingProgram::N_DOF; ++o)
        if (ring.column[o] >= 0) system_.D(ring.column[o], j) += moves[dof] * pushes[o];
    }
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
  // motion of the cage against the ring along both axes, by column
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
