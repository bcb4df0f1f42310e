// SPDX-License-Identifier: GPL-2.0-or-later
// The mathematics of the implicit step behind a C interface, for test_mathematics.py.
#include "../../src-package/physics/arrow_system.h"
#include "../../src-package/physics/turning_frame.h"

using namespace raceway;

static RacewayPhysics outer_6208(double mu)
{
  RacewayPhysics p;
  p.groove = {Side::outer, 36.6e-3, 6.552e-3, 6.3e-3};
  p.model.lubricant = {0.04, 22e-9};
  p.ring_roughness = 1e-7;
  p.friction = Friction::constant;
  p.mu = mu;
  p.creep = 0.01;
  p.prepare(30.3e-3, 8.17e-3, 0.05);
  return p;
}

// State of a ball (x, v, w: 9 numbers) on a 6208 outer ring that turns at `spin`: damping, mu and v_0 come from
// `frozen` (3 numbers) if its first is not negative, and are written there otherwise. Force on the ball.
static ContactState contact(const double *s, double spin, double mu, double *frozen, double *force)
{
  const RacewayPhysics p = outer_6208(mu);
  const BallState ball = {Vec3::from(s), Vec3::from(s + 3), Vec3::from(s + 6)};
  const RingState ring = {{0, 0, 0}, {0, 0, 0}, {0, 0, spin}, {0, 0, 1}};
  ContactState c;
  if (!touch(p, ball.x, ring.e, c)) return c;
  contact_forces<true, Friction::constant>(p, ball, ring, FrictionSmoothed(), c);
  if (frozen[0] < 0) {
    frozen[0] = c.damping;
    frozen[1] = c.mu;
    frozen[2] = c.v_0;
  }
  const double N = std::fmax(0.0, c.load + frozen[0] * c.overlap_rate);
  const double g = smoothed_friction(frozen[1] * N, c.sliding_t, c.sliding_w, frozen[2]);
  const Vec3 n = c.u * c.nu + ring.e * c.ne, w = ring.e * c.nu - c.u * c.ne;
  (n * -N - c.t * (g * c.sliding_t) - w * (g * c.sliding_w)).to(force);
  return c;
}

extern "C" {

void contact_force(const double *state, double spin, double mu, double *frozen, double *force)
{
  contact(state, spin, mu, frozen, force);
}

// D and K of contact_jacobian.h, 9 numbers each, and the normal
void contact_derivatives(const double *state, double spin, double mu, int secant, double *D, double *K, double *n)
{
  double frozen[3] = {-1, 0, 0}, force[3];
  const ContactState c = contact(state, spin, mu, frozen, force);
  const double slack = 6.552e-3 - 6.3e-3;
  const ContactJacobian d = contact_jacobian(c, slack, {0, 0, 1}, 1.0, 0.0, secant);
  const ContactJacobian k = contact_jacobian(c, slack, {0, 0, 1}, 0.0, 1.0, secant);
  for (int i = 0; i < 9; ++i) {
    D[i] = d.both.a[i];
    K[i] = k.both.a[i];
  }
  d.normal.to(n);
}

// Solves a block arrow system; arrays hold 6 rows (columns) a body. Returns 0 if the links form no chain.
int arrow_solve(int bodies, const int *size, const double *A, int border, const double *B, const double *C,
                const double *D, const double *r, const double *ry, int links, const int *pairs, const double *normals,
                const double *a, double *x, double *y)
{
  ArrowSystem s;
  s.resize(bodies, border);
  for (int round = 0; round < 2; ++round) {    // the second time with used memory: same answer
    s.clear();
    for (int k = 0; k < bodies; ++k) {
      s.block[k].size = size[k];
      s.block[k].coupled = border > 0;
      std::copy(A + 36 * k, A + 36 * (k + 1), s.block[k].A);
      for (int m = 0; m < 6; ++m) s.x(k, m)[0] = r[6 * k + m];
      for (int j = 0; j < border; ++j)
        for (int m = 0; m < 6; ++m) {
          s.x(k, m)[1 + j] = B[6 * (k * border + j) + m];
          s.row(k, j)[m] = C[6 * (k * border + j) + m];
        }
    }
    std::copy(D, D + border * border, s.D.begin());
    std::copy(ry, ry + border, s.y.begin());
    for (int i = 0; i < links; ++i)
      if (!s.link(pairs[2 * i], pairs[2 * i + 1], Vec3::from(normals + 3 * i), a[i])) return 0;
    s.solve();
  }
  for (int k = 0; k < bodies; ++k)
    for (int m = 0; m < 6; ++m) x[6 * k + m] = s.x(k, m)[0];
  std::copy(s.y.begin(), s.y.end(), y);
  return 1;
}

// Place and velocity (lab) after a drift of the time h.
void drift(const double *x, const double *v, double h, double *x_new, double *v_new)
{
  const TurningFrame f = TurningFrame::at(Vec3::from(x));
  const Vec3 u = f.local(Vec3::from(v));
  const TurningFrame g = f.drifted(u, h);
  g.place().to(x_new);
  g.lab(u).to(v_new);
}

}
