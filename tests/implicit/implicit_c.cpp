// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the mathematical functions of the implicit step to test_mathematics.py, which calls them
// by name (see src-package/core/interface/exports.h).
#include "../../src-package/core/contact/contact.h"
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/numbers/lane_blocks.h"
#include "../../src-package/core/step/bearing_integrator.h"
#include "../../src-package/core/step/contact_rows.h"

#include <algorithm>

using namespace raceway;

EXPORTS

RECORD(RingEnd, double e[3], rate[2], x[3], v[3];)

using SmoothedLaw = LubricatedLaw<ConstantFrictionPart, SmoothedFrictionPart>;

static RacewayPhysics outer_6208(double mu)
{
  RacewayPhysics p;
  p.groove = {Side::outer, 36.6e-3, 6.552e-3, 6.3e-3};
  p.model.lubricant = {0.04, 22e-9};
  p.ring_roughness = 1e-7;
  p.parts = initial_parts(true);
  p.choose<ConstantFrictionPart>();
  p.choose<SmoothedFrictionPart>();
  p.of<ConstantFrictionPart>().mu = mu;
  p.prepare(30.3e-3, 8.17e-3, 0.05);
  return p;
}

// Computes the force on a ball in the state s (x, v, w: 9 numbers) from a 6208 outer ring that
// rotates at `spin` (rad/s). `frozen` contains damping, mu and the friction's denominator sqrt(s^2
// + v_0^2). They are read from it if its first number is not negative, and are otherwise stored in
// it.
static ContactState contact(const double *s, double spin, double mu, double *frozen, double *force)
{
  const RacewayPhysics p = outer_6208(mu);
  const BallState ball = {Vec3::from(s), Vec3::from(s + 3), Vec3::from(s + 6)};
  const RingState ring = {{0, 0, 0}, {0, 0, 0}, {0, 0, spin}, {0, 0, 1}};
  ContactState c;
  if (!touch(p, ball.x, ring.e, c)) return c;
  find_motions<SmoothedLaw::couples>(p, ball, ring, c);
  SmoothedLaw::act(p, p.law.at(c.cos_angle), LawStates<double>(), c);
  if (frozen[0] < 0) {
    frozen[0] = c.damping;
    frozen[1] = c.mu;
    frozen[2] = std::sqrt(c.sliding_t * c.sliding_t + c.sliding_w * c.sliding_w + c.v_0 * c.v_0);
  }
  const double N = std::fmax(0.0, c.load + frozen[0] * c.overlap_rate),
               g = frozen[1] * N / frozen[2];
  const Vec3 n = c.u * c.nu + ring.e * c.ne, w = ring.e * c.nu - c.u * c.ne;
  (n * -N - c.t * (g * c.sliding_t) - w * (g * c.sliding_w)).to(force);
  return c;
}

static Lane read(const double *p, int stride)
{
  return Lane{p[0], p[stride], p[2 * stride], p[3 * stride]};
}

EXPORT(void, contact_force,
       (const double state[9], double spin, double mu, double frozen[3], double force[3]))
{
  contact(state, spin, mu, frozen, force);
}

// Computes the derivative of the force with respect to the velocity (3 x 3, in the lab frame), and
// the normal. The stage lasts 1 s, and positions follow the velocity for the time `follows` (s).
static void lab_derivative(const ContactState &c, const RacewayPhysics &p, double follows,
                           double *D, double *normal)
{
  ContactState copy = c;
  ContactSlopesT<double, 3> slopes;
  act_with_slopes(SmoothedLaw(), p, LawStates<double>(), follows, copy, slopes);
  ContactStateT<Lane> four;
  ContactSlopesT<Lane, 3> wide;
  four.u = {all_lanes(c.u.x), all_lanes(c.u.y), all_lanes(c.u.z)};
  four.t = {all_lanes(c.t.x), all_lanes(c.t.y), all_lanes(c.t.z)};
  four.nu = all_lanes(c.nu);
  four.ne = all_lanes(c.ne);
  four.r = all_lanes(c.r);
  four.s = all_lanes(c.s);
  four.normal = all_lanes(copy.normal);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) wide.of[i][k] = all_lanes(slopes.of[i][k]);
  const Vec3L e = {Lane{}, Lane{}, all_lanes(1.0)};
  const ScaledSlopes<3> s = scaled(1.0, follows, four, e, LaneMask{-1, -1, -1, -1}, wide);
  Lane row[3][6];
  ball_rows(s, p.groove.ball_radius, row);
  for (int k = 0; k < 3; ++k) {
    Lane motion[3] = {row[0][k], row[1][k], row[2][k]}, force[3];
    local_forces(s, motion, true, force);
    for (int m = 0; m < 3; ++m)
      D[3 * m + k] = (row[0][m] * force[0] + row[1][m] * force[1] + row[2][m] * force[2])[0];
    normal[k] = row[0][k][0];
  }
}

// Computes the derivative D with respect to velocity at constant position, the derivative K with
// respect to position, and the normal.
EXPORT(void, contact_derivatives,
       (const double state[9], double spin, double mu, double D[9], double K[9], double n[3]))
{
  double frozen[3] = {-1, 0, 0}, force[3], both[9];
  const ContactState c = contact(state, spin, mu, frozen, force);
  const RacewayPhysics p = outer_6208(mu);
  lab_derivative(c, p, 0.0, D, n);
  lab_derivative(c, p, 1.0, both, n);
  for (int k = 0; k < 9; ++k) K[k] = both[k] - D[k];
}

// Solves four systems of size 6 or 3. Rows of A[4][36] are 6 numbers apart; r[4][6] contains the
// right-hand sides on entry and the solutions on return.
EXPORT(void, blocks, (int n, const double A[144], double r[24]))
{
  Lane a[36], x[6];
  for (int k = 0; k < 36; ++k) a[k] = read(A + k, 36);
  for (int k = 0; k < 6; ++k) x[k] = read(r + k, 6);
  if (n == 6) {
    factor<6>(a);
    substitute<6>(a, x);
  } else {
    factor<3>(a);
    substitute<3>(a, x);
  }
  for (int k = 0; k < 6; ++k)
    for (int i = 0; i < lanes; ++i) r[6 * i + k] = x[k][i];
}

EXPORT(void, dense, (int n, const double *A, double *y))
{
  DenseLU lu;
  lu.resize(n);
  std::copy(A, A + n * n, lu.a.begin());
  lu.factor();
  lu.solve(y);
}

// Solves for the forces in links between bodies, from the inverse blocks of the bodies (9 numbers
// each); x contains right-hand sides on entry and forces on return.
EXPORT(int, chain,
       (int bodies, const double *inverse, int links, const int *pairs, const double *normals,
        const double *a, double *x))
{
  LinkChain c;
  c.resize(bodies);
  // solves a second time with the same memory; the result must be the same
  for (int round = 0; round < 2; ++round) {
    c.clear();
    for (int i = 0; i < links; ++i) {
      const Vec3 n = Vec3::from(normals + 3 * i);
      if (!c.add(pairs[2 * i], pairs[2 * i + 1], n, n, a[i])) return 0;
    }
    for (LinkChain::Link &l : c.links)
      for (LinkChain::End &e : l.end) {
        const double *m = inverse + 9 * e.body;
        e.answer = {dot(Vec3::from(m), e.n), dot(Vec3::from(m + 3), e.n),
                    dot(Vec3::from(m + 6), e.n)};
      }
    c.factor();
  }
  c.solve(x);
  return 1;
}

// Computes position and velocity in the lab frame after a drift of h seconds.
EXPORT(void, drift,
       (const double x[3], const double v[3], double h, double x_new[3], double v_new[3]))
{
  LaneFrame f;
  for (int i = 0; i < lanes; ++i) f.set(i, Vec3::from(x));
  const Vec3L u = f.local(Vec3::from(v));
  Lane turn;
  const LaneFrame g = f.drifted(u, h, turn);
  const Vec3L place = g.place(), speed = g.lab(u);
  for (int k = 0; k < 3; ++k) {
    x_new[k] = (k == 0 ? place.x : k == 1 ? place.y : place.z)[0];
    v_new[k] = (k == 0 ? speed.x : k == 1 ? speed.y : speed.z)[0];
  }
}

EXPORT(double, cubic, (double s, double h, double x_from, double v_from, double x_to, double v_to))
{
  return Cubic(s, h)(x_from, v_from, x_to, v_to);
}

// Computes the axis of a ring half-way between two instants h seconds apart; the ring rotates about
// `w` at a constant rate.
EXPORT(void, axis_between, (const double w[3], double h, double e[3]))
{
  const Vec3 W = Vec3::from(w);
  RingPose from, to;
  from.e = rotate({0.0, 0.0, 1.0}, {0.1, -0.05, 0.0});
  from.set_angular_velocity(W);
  to.e = rotate(from.e, W * h);
  to.set_angular_velocity(W);
  const Vec3 found = between(from, to, h, 0.5).e, truth = rotate(from.e, W * (0.5 * h));
  (found - truth).to(e);
}

EXPORT(void, turn, (double angle, double c[1], double s[1]))
{
  Lane cosine, sine;
  small_turn(all_lanes(angle), cosine, sine);
  *c = cosine[0];
  *s = sine[0];
}

// A ring that is alone except for a ball that it does not touch.
struct LoneRing {
  BearingModel model;
  RingProgram program;
  std::vector<BodyPose> bodies = {{{30e-3, 0, 0}, Vec3(), Vec3(), {}}};
  std::vector<RingPose> rings = std::vector<RingPose>(1);

  LoneRing()
  {
    model.bodies.push_back({1, 1.0, 5e-3, true});
    model.rings.push_back({2, 0, {}});
    program.mass = 0.5;
  }
};

// A 6208 outer raceway without lubricant or damping.
static RacewayPhysics dry_outer()
{
  RacewayPhysics outer = outer_6208(0.0);
  outer.parts = initial_parts(false);
  outer.of<HysteresisPart>().alpha_e = 0.0;
  return outer;
}

// Computes the state after n steps of a single ring that is free except for its driven spin, under
// a constant force and moment. If order is 0, only dampers are implicit.
EXPORT(void, lone_ring,
       (int order, int n, double h, double spin, const double inertia[2], const double moment[3],
        RingEnd *out))
{
  LoneRing alone;
  auto &[m, p, bodies, rings] = alone;
  BearingIntegrator step(m);
  for (Freedom &f : p.mode) f = Freedom::free;
  p.mode[RingProgram::SPIN] = Freedom::speed;
  p.inertia = {inertia[0], inertia[1]};
  p.target[0][RingProgram::SPIN] = p.target[1][RingProgram::SPIN] = spin;
  p.moment[0] = p.moment[1] = Vec3::from(moment);
  p.force[0] = p.force[1] = {1.0, 2.0, 3.0};
  step.set_program(0, p);
  rings[0].spin = spin;
  step.load(bodies, rings);
  BearingIntegrator::Settings set;
  set.order = order;
  set.dampers_only = order == 0;
  set.newton = 1e-15;
  set.corrections = 30;
  for (int k = 0; k < n; ++k) {
    step.step(set, h, 0.0, 1.0);
    step.accept();
  }
  step.store(bodies, rings);
  rings[0].e.to(out->e);
  out->rate[0] = rings[0].rate[0];
  out->rate[1] = rings[0].rate[1];
  rings[0].x.to(out->x);
  rings[0].v.to(out->v);
}

// Simulates a single ring of 0.5 kg that is free along z, on a spring (stiffness 0: no spring),
// under a constant force. It moves from place[0] (m) and velocity[0] (m/s) to place[1] and
// velocity[1] in n steps of h seconds, with a relative tolerance. Returns the largest error (m)
// estimated in a step.
EXPORT(double, estimated_errors,
       (double relative, int n, double h, double stiffness, double force, double place[2],
        double velocity[2]))
{
  LoneRing alone;
  auto &[m, p, bodies, rings] = alone;
  BearingIntegrator step(m);
  p.mode[2] = Freedom::free;
  p.force[0] = p.force[1] = {0.0, 0.0, force};
  p.support[2].stiffness = stiffness;
  p.supported = stiffness > 0.0;
  step.set_program(0, p);
  rings[0].x.z = place[0];
  rings[0].v.z = velocity[0];
  step.load(bodies, rings);
  BearingIntegrator::Settings set;
  set.estimate = true;
  set.newton = 1e-18;
  set.relative = relative;
  double largest = 0.0;
  for (int k = 0; k < n; ++k) {
    largest = std::max(largest, step.step(set, h, 0.0, 1.0).error);
    step.accept();
  }
  step.store(bodies, rings);
  place[1] = rings[0].x.z;
  velocity[1] = rings[0].v.z;
  return largest;
}

// Computes corrections of the velocity (x, y, z) of a free ring of 0.5 kg under a force of (1, 2,
// 3) N: first with new factors, then twice with the same factors.
EXPORT(void, old_factors, (double h, double found[9]))
{
  LoneRing alone;
  BearingBodies b(alone.model);
  BearingSystem system(b);
  BearingForces forces(b, system);
  RingProgram &p = b.rings[0].program;
  p = alone.program;
  p.mode[0] = p.mode[1] = p.mode[2] = Freedom::free;
  p.force[0] = p.force[1] = {1.0, 2.0, 3.0};
  b.load(alone.bodies, alone.rings);
  RingBody &ring = b.rings[0];
  BodyGroup &g = b.groups[0];
  b.start();
  g.now = g.from;
  ring.now = ring.from;
  Stage stage;
  stage.h = h;
  for (int pass = 0; pass < 3; ++pass) {
    const bool fresh = pass == 0;
    stage.evaluate = fresh ? Evaluate::derivatives : Evaluate::residual;
    system.start(h, fresh);
    forces.evaluate(stage);
    system.add_border(h, stage.follows(), 1.0, fresh);
    if (fresh) system.factor();
    system.solve();
    for (int k = 0; k < 3; ++k) found[3 * pass + k] = system.y(k);
  }
}

// Computes the matrix of the linear system, and difference quotients of its right-hand side, for a
// ball on an outer raceway with a notch, or a ball with a pit, in a stage of h seconds. Rows:
// velocity and spin of the ball; columns: velocity and spin of the ball, then x, y and spin of the
// outer ring.
EXPORT(void, flawed_system,
       (const double notch[4], int of_ball, double off_middle, double overlap, double h,
        double matrix[54], double differences[54], double transposed[18]))
{
  RacewayPhysics outer = dry_outer();
  NotchShape shape = {0.7, notch[0], notch[1] > 0.0 ? notch[1] : HUGE_VAL, notch[2], notch[3]};
  const double rolling = outer.rolling_radius(1.0), ellipse = outer.law.radial().a;
  const RacewayProfile profile({{shape}, {{31, 1e-6, 0.2}}, {}}, outer.groove.raceway_radius,
                               rolling, ellipse);
  BearingModel model;
  model.bodies = {{1, 8.17e-3, 6.3e-3, true}};
  model.rings = {{2, 0, {}}};
  BallPitShape pit;
  static_cast<NotchShape &>(pit) = shape;
  const BallProfile ball({{pit}, {{7, 2e-7, 0.2}}}, outer.groove.ball_radius, rolling, ellipse,
                         outer.law.radial().K);
  model.grooves = {{0, 0, &outer, of_ball ? nullptr : &profile, of_ball ? &ball : nullptr}};
  model.parts = outer.parts;
  BearingBodies b(model);
  BearingSystem system(b);
  BearingForces forces(b, system);
  RingProgram &free = b.rings[0].program;
  free.mode[0] = free.mode[1] = free.mode[RingProgram::SPIN] = Freedom::free;
  free.mass = 0.3;
  free.inertia = {3e-4, 1.6e-4};
  const double at = 0.7 + off_middle / (of_ball ? 6.3e-3 : 36.6e-3), r = 30.3e-3 + overlap;
  RingPose pose;
  pose.spin = 3.0;
  const Vec3 u = {std::cos(at), std::sin(at), 0.0}, t = {-u.y, u.x, 0.0};
  b.load({{u * r, t * 2.0 + u * 0.01, {0.0, 0.0, -250.0}, {}}}, {pose});
  RingBody &ring = b.rings[0];
  BodyGroup &g = b.groups[0];
  Stage stage;
  stage.h = h;
  const int dofs[] = {0, 1, RingProgram::SPIN};
  // changes one velocity component; positions follow
  const auto solve = [&](int which, double change, Evaluate what) {
    b.start();
    Lane *v[] = {&g.v.x, &g.v.y, &g.v.z, &g.w.x, &g.w.y, &g.w.z};
    if (which >= 0 && which < 6) *v[which] += change;
    if (which >= 6) ring.gained[dofs[which - 6]] = change;
    g.now = g.base.drifted(g.v, h, g.turn);
    ring.move(h, 1.0);
    for (BallTurns &turns : b.turns) turns.move(g, h);
    stage.evaluate = what;
    system.start(h, true);
    forces.evaluate(stage);
  };
  for (int k = 0; k < 9; ++k) {
    const double change = k < 3 || k == 6 || k == 7 ? 1e-4 : 1e-2;
    solve(k, change, Evaluate::residual);
    Lane up[6];
    std::copy(g.rhs, g.rhs + 6, up);
    solve(k, -change, Evaluate::residual);
    for (int m = 0; m < 6; ++m) differences[9 * m + k] = (g.rhs[m][0] - up[m][0]) / (2.0 * change);
  }
  solve(-1, 0.0, Evaluate::derivatives);
  for (int m = 0; m < 6; ++m) {
    for (int k = 0; k < 6; ++k) matrix[9 * m + k] = g.A[6 * m + k][0];
    for (int k = 0; k < 3; ++k) {
      matrix[9 * m + 6 + k] = system.B(0, k)[m][0];
      transposed[3 * m + k] = system.C(0, k)[m][0];
    }
  }
}

// Simulates a ball that rolls around an outer raceway in steps of h seconds. Only inertia presses
// it on the raceway, from which it is initially `gap` (m) away. Returns the number of corrections
// and the estimated error of each step, and the overlap after the step. If `heavy` (m) is above 0,
// a second ball with this overlap also rolls around.
EXPORT(void, resting,
       (double speed, double gap, double heavy, double newton, double h, int n, double *corrections,
        double *error, double *overlap))
{
  RacewayPhysics outer = dry_outer();
  BearingModel model;
  model.bodies = {{1, 8.17e-3, 6.3e-3, true}};
  model.rings = {{2, 0, {}}};
  model.grooves = {{0, 0, &outer}};
  model.parts = outer.parts;
  std::vector<BodyPose> bodies = {{{30.3e-3 - gap, 0.0, 0.0}, {0.0, speed, 0.0}, Vec3()}};
  if (heavy > 0.0) {
    model.bodies.push_back({3, 8.17e-3, 6.3e-3, true});
    model.grooves.push_back({1, 0, &outer});
    bodies.push_back({{-30.3e-3 - heavy, 0.0, 0.0}, Vec3(), Vec3()});
  }
  BearingIntegrator step(model);
  std::vector<RingPose> rings(1);
  step.load(bodies, rings);
  BearingIntegrator::Settings set;
  set.newton = newton;
  set.corrections = 30;
  for (int k = 0; k < n; ++k) {
    const BearingIntegrator::Outcome o = step.step(set, h, 0.0, 1.0);
    corrections[k] = o.solved() ? o.corrections : HUGE_VAL;
    error[k] = o.error;
    step.accept();
    step.store(bodies, rings);
    overlap[k] = std::hypot(bodies[0].x.x, bodies[0].x.y) - 30.3e-3;
  }
}

// Computes the number of corrections in a step of h seconds in which a ball approaches the cage
// ball ahead of it; HUGE_VAL if there is no solution.
EXPORT(void, meeting, (double gap, double speed, double h, double newton, double *corrections))
{
  BearingModel model;
  model.bodies = {{1, 8.17e-3, 6.3e-3, true}, {2, 3.5e-4, 4.19e-3, false}};
  model.rings = {{3, 0, {}}};
  const double reach = 6.3e-3 + 4.19e-3;
  model.pockets = {{0, 1, 1.3e9, reach, 3.4e-4}};
  const double angle = 2.0 * std::asin(0.5 * (reach + gap) / 30.3e-3), c = std::cos(angle),
               s = std::sin(angle);
  BearingIntegrator step(model);
  const double r = 30.3e-3;
  step.load({{{r, 0.0, 0.0}, {0.0, speed, 0.0}, Vec3()}, {{r * c, r * s, 0.0}, Vec3(), Vec3()}},
            std::vector<RingPose>(1));
  BearingIntegrator::Settings set;
  set.newton = newton;
  const BearingIntegrator::Outcome o = step.step(set, h, 0.0, 1.0);
  *corrections = o.solved() ? o.corrections : HUGE_VAL;
}

// For a ball and a ring that is free along both radial axes, matrix[48] is the block of the ball
// (36 numbers) and its columns for the ring (12 numbers). restored[48] contains these numbers as
// restore() returns them after corrections with new derivatives and, if `again`, also after
// corrections with old derivatives.
EXPORT(void, matrix_kept, (int again, const double matrix[48], double restored[48]))
{
  BearingModel model;
  model.bodies = {{1, 8e-3, 6.3e-3, true}};
  model.rings = {{2, 0, {}}};
  BearingBodies b(model);
  b.rings[0].program.mode[0] = b.rings[0].program.mode[1] = Freedom::free;
  b.rings[0].program.mass = 0.2;
  b.load({BodyPose{{30e-3, 0.0, 0.0}, {}, {}}}, {RingPose()});
  b.start();
  BearingSystem system(b);
  const auto each = [&](const auto &act) {
    for (int k = 0; k < 36; ++k) act(b.groups[0].A[k], k);
    for (int k = 0; k < 12; ++k) act(system.B(0, k / 6)[k % 6], 36 + k);
  };
  for (const bool fresh : {true, false}) {
    if (!fresh && !again) break;
    system.start(1.0, fresh);
    if (fresh) each([&](Lane &to, int k) { to = all_lanes(matrix[k]); });
    b.groups[0].coupled = true;
    system.keep(fresh);
    system.add_border(1.0, 1.0, 1.0, fresh);
    if (fresh) system.factor();
    system.solve();
  }
  system.restore();
  each([&](const Lane &from, int k) { restored[k] = from[0]; });
}
