// SPDX-License-Identifier: GPL-2.0-or-later
// The linear system of one Newton correction:
//   A_k x_k + B_k y + sum_i s_ik n_i l_i = r_k        x_k of a body, s_ik = +1 first, -1 second
//   body of link i sum_k C_k x_k + D y                  = r_y        y of the free degrees of
//   freedom of the rings l_i/a_i = n_i . (x_first - x_second)              closed cage contacts
// solved block by block, link by link, then y, and back. factor() keeps what solve() needs, so that
// later corrections with the same derivatives cost one right-hand side.
#include "bearing_step.h"
#include "lane_blocks.h"

#include <algorithm>

namespace raceway {

// Residual of the rings, and the part of D that no contact brings.
void BearingStep::border_rhs(double h, double s)
{
  const int nf = static_cast<int>(free_.size());
  for (int f = 0; f < nf; ++f) {
    const int dof = free_[f].dof;
    const Ring &r = rings_[free_[f].ring];
    const RingPose &now = r.now;
    const double inertia = r.program.inertia_of(dof);
    border_.a[f * nf + f] += inertia;
    if (dof < RingProgram::TILT) {
      const Vec3 push = r.force + r.program.force_at(s);
      y_[f] = h * (dof == 0 ? push.x : dof == 1 ? push.y : push.z) - inertia * r.gained[dof];
      continue;
    }
    const Vec3 M = r.moment + r.program.moment_at(s);
    const double along = dot(M, now.e);
    if (dof == RingProgram::SPIN) {
      y_[f] = h * along - inertia * r.gained[dof];
      continue;
    }
    const double momentum = r.program.inertia.axial * now.spin;
    const Vec3 turn = cross(now.across(), now.e);
    const double M_across =
        dof == RingProgram::TILT ? M.x - along * now.e.x : M.y - along * now.e.y;
    y_[f] = h * (M_across - momentum * (dof == RingProgram::TILT ? turn.x : turn.y)) -
            inertia * r.gained[dof];
    const int other = r.unknown[dof == RingProgram::TILT ? dof + 1 : dof - 1];
    if (other >= 0)
      border_.a[f * nf + other] += dof == RingProgram::TILT ? h * momentum : -h * momentum;
  }
}

RACEWAY_LANES void BearingStep::factor_groups()
{
  const size_t nf = free_.size();
  for (size_t k = 0; k < groups_.size(); ++k) {
    Group &g = groups_[k];
    if (g.spins) raceway::factor<6>(g.A);
    else raceway::factor<3>(g.A);
    if (g.coupled)
      for (size_t f = 0; f < nf; ++f) {
        if (g.spins) substitute<6>(g.A, B_[k * nf + f].a);
        else substitute<3>(g.A, B_[k * nf + f].a);
      }
    if (!g.linked) continue;
    for (Lane(&column)[6] : g.link) {
      if (g.spins) substitute<6>(g.A, column);
      else substitute<3>(g.A, column);
    }
  }
}

void BearingStep::factor()
{
  const int nf = static_cast<int>(free_.size());
  for (Group &g : groups_)
    if (g.linked)
      for (Lane(&column)[6] : g.link) std::fill(column, column + 6, Lane{});
  for (const LinkChain::Link &l : chain_.links)
    for (const LinkChain::End &e : l.end) {
      Lane *column = groups_[e.body / lanes].link[e.slot];
      const int i = e.body % lanes;
      column[0][i] = e.n.x;
      column[1][i] = e.n.y;
      column[2][i] = e.n.z;
    }
  factor_groups();
  if (!chain_.links.empty()) {
    for (LinkChain::Link &l : chain_.links)
      for (LinkChain::End &e : l.end) {
        const Lane *column = groups_[e.body / lanes].link[e.slot];
        const int i = e.body % lanes;
        e.answer = {column[0][i], column[1][i], column[2][i]};
      }
    chain_.factor();
    for (int f = 0; f < nf; ++f)
      condense_links([&](int group) { return B_[group * nf + f].a; }, true);
  }
  for (size_t k = 0; k < groups_.size(); ++k) {
    const Group &g = groups_[k];
    if (!g.coupled) continue;
    const int n = g.spins ? 6 : 3;
    for (int i = 0; i < nf; ++i)
      for (int j = 0; j < nf; ++j) {
        Lane s = {};
        for (int m = 0; m < n; ++m) s += C_[k * nf + i].a[m] * B_[k * nf + j].a[m];
        border_.a[i * nf + j] -= sum(where(g.used, s, 0.0));
      }
  }
  border_.factor();
}

// Takes the links' forces out of columns that are already A^-1 times something.
template <class ColumnOf> void BearingStep::condense_links(ColumnOf column, bool mark)
{
  forces_.resize(chain_.links.size());
  for (size_t i = 0; i < chain_.links.size(); ++i) {
    double v = 0.0;
    for (int k = 0; k < 2; ++k) {
      const LinkChain::End &e = chain_.links[i].end[k];
      const Lane *x = column(e.body / lanes);
      const int lane = e.body % lanes;
      const double along = e.n.x * x[0][lane] + e.n.y * x[1][lane] + e.n.z * x[2][lane];
      v += k == 0 ? along : -along;
    }
    forces_[i] = v;
  }
  chain_.solve(forces_.data());
  for (size_t i = 0; i < chain_.links.size(); ++i)
    for (int k = 0; k < 2; ++k) {
      const LinkChain::End &e = chain_.links[i].end[k];
      Group &g = groups_[e.body / lanes];
      if (mark) g.coupled = true;
      Lane *x = column(e.body / lanes);
      const int lane = e.body % lanes, n = g.spins ? 6 : 3;
      const double f = k == 0 ? forces_[i] : -forces_[i];
      for (int m = 0; m < n; ++m) x[m][lane] -= f * g.link[e.slot][m][lane];
    }
}

RACEWAY_LANES void BearingStep::solve()
{
  const int nf = static_cast<int>(free_.size());
  for (Group &g : groups_) {
    if (g.spins) substitute<6>(g.A, g.rhs);
    else substitute<3>(g.A, g.rhs);
  }
  if (!chain_.links.empty())
    condense_links([this](int group) { return groups_[group].rhs; }, false);
  if (nf == 0) return;
  for (size_t k = 0; k < groups_.size(); ++k) {
    const Group &g = groups_[k];
    if (!g.coupled) continue;
    const int n = g.spins ? 6 : 3;
    for (int i = 0; i < nf; ++i) {
      Lane s = {};
      for (int m = 0; m < n; ++m) s += C_[k * nf + i].a[m] * g.rhs[m];
      y_[i] -= sum(where(g.used, s, 0.0));
    }
  }
  border_.solve(y_.data());
  for (size_t k = 0; k < groups_.size(); ++k) {
    Group &g = groups_[k];
    if (!g.coupled) continue;
    const int n = g.spins ? 6 : 3;
    for (int f = 0; f < nf; ++f)
      for (int m = 0; m < n; ++m) g.rhs[m] -= B_[k * nf + f].a[m] * y_[f];
  }
}

// Adds the correction; returns its size, m: largest over balls across the raceways and over the
// rings.
RACEWAY_LANES double BearingStep::apply(double h)
{
  Lane off = {};
  bool finite = true;
  for (size_t k = 0; k < groups_.size(); ++k) {
    Group &g = groups_[k];
    const Vec3L dv = Vec3L::from(g.rhs);
    g.v += dv;
    const Lane all = magnitude(dv.x) + magnitude(dv.y) + magnitude(dv.z);
    const LaneMask bad = g.used & ~(all < HUGE_VAL);
    if (any(bad)) {
      finite = false;
      for (int i = 0; i < lanes; ++i)
        if (bad[i]) worst_ = body_at_[lanes * k + i];
    }
    if (g.spins) g.w += Vec3L::from(g.rhs + 3);
    const Lane worse = where(magnitude(dv.x) > magnitude(dv.z), magnitude(dv.x), magnitude(dv.z));
    off = where(g.used & (worse > off), worse, off);
  }
  double largest = std::max(std::max(off[0], off[1]), std::max(off[2], off[3]));
  for (size_t f = 0; f < free_.size(); ++f) {
    rings_[free_[f].ring].gained[free_[f].dof] += y_[f];
    finite = finite && std::fabs(y_[f]) < HUGE_VAL;
    if (free_[f].dof == RingProgram::SPIN) continue;
    const double lever = free_[f].dof < RingProgram::TILT ? 1.0 : groups_.front().now.r[0];
    largest = std::max(largest, std::fabs(y_[f]) * lever);
  }
  return finite ? h * largest : HUGE_VAL;
}

}    // namespace raceway
