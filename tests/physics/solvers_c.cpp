// SPDX-License-Identifier: GPL-2.0-or-later
// Exports the solvers of linear systems of the implicit step to test_physics_solvers.py.
#include "../../src-package/core/interface/exports.h"
#include "../../src-package/core/numbers/lane_blocks.h"
#include "small_bearings.h"

#include <algorithm>

using namespace raceway;

static Lane read(const double *p, int stride)
{
  return Lane{p[0], p[stride], p[2 * stride], p[3 * stride]};
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
  b.load({BodyPose{{30e-3, 0.0, 0.0}, {}, {}, {}}}, {RingPose()});
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
