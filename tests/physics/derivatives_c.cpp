// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the derivatives of contacts that the implicit step uses to test_physics_derivatives.py.
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/step/contact_rows.h"
#include "small_bearings.h"

using namespace raceway;

using SmoothedLaw = LubricatedLaw<ConstantFrictionPart, SmoothedFrictionPart>;

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
  const BallProfile ball({{pit}, {{7, 2e-7, 0.2}}, {}}, outer.groove.ball_radius, rolling, ellipse,
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
