// SPDX-License-Identifier: GPL-2.0-or-later
#include "bearing_system.h"

#include "../numbers/lane_blocks.h"

#include <algorithm>

namespace raceway {

void BearingSystem::resize()
{
  const size_t nf = b_.columns, n = b_.border.size();
  if (y_.size() == n && B_.size() == b_.groups.size() * nf) return;
  B_.assign(b_.groups.size() * nf, Column());
  C_.assign(b_.groups.size() * nf, Column());
  border_.resize(static_cast<int>(n));
  y_.assign(n, 0.0);
  corner_ = border_.a.data();
  motions_ = y_.data();
  if (b_.bends.empty()) return;
  corner_apart_.assign(nf * nf, 0.0);
  motions_apart_.assign(nf, 0.0);
  corner_ = corner_apart_.data();
  motions_ = motions_apart_.data();
}

// Sets the columns B to 0, and the rows C of cages or of all rings, if they have been filled.
RACEWAY_LANES void BearingSystem::clear(bool only_cages)
{
  const size_t nf = b_.columns;
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    if (!b_.groups[k].coupled) continue;
    const int n = b_.groups[k].spins ? 6 : 3;
    const BearingBodies::GroupColumns &columns = b_.columns_of_group[k];
    for (int f : columns.all) std::fill_n(B_[k * nf + f].a, n, Lane{});
    for (int f : columns.of_cages) std::fill_n(C_[k * nf + f].a, n, Lane{});
    if (only_cages) continue;
    for (int f : columns.of_raceways) std::fill_n(C_[k * nf + f].a, n, Lane{});
  }
}

RACEWAY_LANES void BearingSystem::start(double h, bool fresh)
{
  if (fresh) {
    resize();
    clear(false);
  }
  for (BodyGroup &g : b_.groups) {
    const Lane rate = g.v.y / g.now.r;
    Vec3L free_fall = frame_acceleration(rate, g.v);
    if (b_.heavy) free_fall += g.now.local(b_.gravity);
    const Vec3L dv = (g.v_base - g.v + free_fall * h) * g.mass;
    dv.to(g.rhs);
    if (g.spins) {
      const Vec3L dw = (g.w_base - g.w + frame_acceleration(rate, g.w) * h) * g.inertia;
      dw.to(g.rhs + 3);
    }
    if (!fresh) continue;
    for (Lane &a : g.A) a = Lane{};
    for (int m = 0; m < 3; ++m) g.A[7 * m] = g.mass;
    for (int m = 3; m < 6; ++m) g.A[7 * m] = g.inertia;
    g.coupled = g.linked = false;
    g.spring = g.damper = g.stiffness = Lane{};
  }
  if (!fresh) return;
  for (RingBody &r : b_.rings) r.spring = 0.0;
  std::fill(border_.a.begin(), border_.a.end(), 0.0);
  std::fill(corner_apart_.begin(), corner_apart_.end(), 0.0);
}

void BearingSystem::add_border(double h, double follows, double s, bool fresh)
{
  const size_t n = b_.border.size();
  b_.border_forces(s, y_);
  auto by = b_.couplings.begin();
  for (size_t k = 0; k < n; ++k) {
    const Coordinate &c = b_.border[k];
    y_[k] = h * y_[k] - *c.mass * *c.gained;
    if (!fresh) continue;
    border_.a[k * n + k] += *c.mass + h * (c.damper + follows * c.spring);
    for (; by != b_.couplings.end() && by->after == static_cast<int>(k); ++by)
      add_coupling(*by, h, follows);
  }
  add_spins(h, fresh);
}

void BearingSystem::keep(bool fresh)
{
  const size_t nf = columns();
  kept_.groups.resize(b_.groups.size());
  kept_.B.resize(B_.size());
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    const BodyGroup &g = b_.groups[k];
    KeptGroup &to = kept_.groups[k];
    std::copy(g.rhs, g.rhs + 6, to.rhs);
    if (!fresh) continue;
    std::copy(g.A, g.A + 36, to.A);
    to.coupled = g.coupled;
    if (!g.coupled) continue;
    for (int f : b_.columns_of_group[k].of_raceways) kept_.B[k * nf + f] = B_[k * nf + f];
  }
  kept_.y.assign(columns(), 0.0);
  kept_.pushes.clear();
  for (const RingBody &r : b_.rings) {
    kept_.pushes.push_back(r.force_lanes);
    kept_.pushes.push_back(r.moment_lanes);
  }
  if (!fresh) return;
  kept_.corner.assign(corner_, corner_ + columns() * columns());
}

RACEWAY_LANES void BearingSystem::restore()
{
  const int nf = columns();
  clear(true);
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    BodyGroup &g = b_.groups[k];
    KeptGroup &from = kept_.groups[k];
    const int n = g.spins ? 6 : 3;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) from.rhs[i] -= from.A[6 * i + j] * g.rhs[j];
    if (from.coupled)
      for (int f : b_.columns_of_group[k].of_raceways) {
        Lane s = {};
        for (int i = 0; i < n; ++i) {
          from.rhs[i] -= kept_.B[k * nf + f].a[i] * motions_[f];
          s += C_[k * nf + f].a[i] * g.rhs[i];
        }
        kept_.y[f] -= sum(where(g.used, s, 0.0));
        B_[k * nf + f] = kept_.B[k * nf + f];
      }
    std::copy(from.A, from.A + 36, g.A);
    std::copy(from.rhs, from.rhs + 6, g.rhs);
    g.coupled = from.coupled;
    g.linked = false;
  }
  for (int i = 0; i < nf; ++i)
    for (int j = 0; j < nf; ++j) kept_.y[i] -= kept_.corner[i * nf + j] * motions_[j];
  std::copy(kept_.corner.begin(), kept_.corner.end(), corner_);
  if (corner_ != border_.a.data()) std::fill(border_.a.begin(), border_.a.end(), 0.0);
  auto push = kept_.pushes.begin();
  for (RingBody &r : b_.rings) {
    r.force_lanes = *push++;
    r.moment_lanes = *push++;
  }
}

void BearingSystem::add_kept()
{
  if (!b_.bends.empty()) lift_.add_forces(kept_.y, y_);
  else
    for (int k = 0; k < columns(); ++k) y_[k] += kept_.y[k];
}

void BearingSystem::add_coupling(const Coupling &c, double h, double follows)
{
  const size_t n = b_.border.size();
  const double stiff = h * (c.by->damping + follows * c.by->stiffness);
  for (const auto &row : c.of)
    for (const auto &column : c.of)
      border_.a[row.first * n + column.first] += stiff * row.second * column.second;
}

// Adds the gyroscopic coupling between the two tilts of a ring, and the one between the modes of a
// shaft.
void BearingSystem::add_spins(double h, bool fresh)
{
  const size_t n = b_.border.size();
  const auto a = [this, n](int row, int column) -> double & { return border_.a[row * n + column]; };
  for (const RingBody &r : b_.rings) {
    const int first = r.coordinate[RingProgram::TILT], second = r.coordinate[RingProgram::TILT + 1];
    if (!fresh || r.carried || first < 0 || second < 0) continue;
    const double turn = h * (r.program.inertia.axial * r.now.spin);
    a(first, second) += turn;
    a(second, first) -= turn;
  }
  for (const ShaftBend &b : b_.bends) {
    const RingBody &shaft = b_.rings[b.shaft];
    const ShaftModes &m = *b.modes;
    const int size = m.size(), *tilt = shaft.coordinate + RingProgram::TILT;
    const Vec3 moment = moment_of_modes(m, b.now, shaft.now.spin);
    y_[tilt[0]] += h * moment.x;
    y_[tilt[1]] += h * moment.y;
    if (!fresh) continue;
    const double turn = h * shaft.now.spin;
    for (int k = 0; k < size; ++k) {
      const int mode[2] = {b.mode + k, b.mode + size + k};    // mode k in both planes
      for (int j = 0; j < size; ++j) {
        const double g = turn * m.g(k + 1, j + 1);
        a(mode[0], b.mode + size + j) += g;
        a(mode[1], b.mode + j) -= g;
      }
      const double g = turn * m.g(0, k + 1);
      for (int plane = 0; plane < 2; ++plane) {
        a(mode[plane], tilt[plane]) -= g;
        a(tilt[plane], mode[plane]) += g;
      }
    }
  }
}

RACEWAY_LANES void BearingSystem::factor_groups()
{
  const size_t nf = b_.columns;
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    BodyGroup &g = b_.groups[k];
    if (g.spins) raceway::factor<6>(g.A);
    else raceway::factor<3>(g.A);
    if (g.coupled)
      for (int f : b_.columns_of_group[k].all) {
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

// Subtracts C B of a group from D, for a row i of C. B begins with the first column of the group;
// each body has n velocities. The row of D has as many elements as there are columns.
template <int n>
static RACEWAY_INLINE void condense(const Lane *C, const BearingSystem::Column *B,
                                    const std::vector<int> &columns, const LaneMask &used,
                                    double *D)
{
  Lane c[n];
  for (int m = 0; m < n; ++m) c[m] = where(used, C[m], 0.0);
  for (int j : columns) {
    Lane s = c[0] * B[j].a[0];
    for (int m = 1; m < n; ++m) s += c[m] * B[j].a[m];
    D[j] -= sum(s);
  }
}

// Eliminates the bodies from the border after B has been condensed with their blocks and links.
RACEWAY_LANES void BearingSystem::condense_groups()
{
  const size_t nf = b_.columns;
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    const BodyGroup &g = b_.groups[k];
    if (!g.coupled) continue;
    const BearingBodies::GroupColumns &columns = b_.columns_of_group[k];
    for (const std::vector<int> *rows : {&columns.of_raceways, &columns.of_cages})
      for (int i : *rows) {
        const Lane *C = C_[k * nf + i].a;
        if (g.spins) condense<6>(C, &B_[k * nf], columns.all, g.used, corner_ + i * nf);
        else condense<3>(C, &B_[k * nf], columns.all, g.used, corner_ + i * nf);
      }
  }
}

void BearingSystem::factor()
{
  const int nf = b_.columns;
  for (BodyGroup &g : b_.groups)
    if (g.linked)
      for (Lane(&column)[6] : g.link) std::fill(column, column + 6, Lane{});
  for (const LinkChain::Link &l : chain_.links)
    for (const LinkChain::End &e : l.end) {
      Lane *column = b_.groups[e.body / lanes].link[e.slot];
      const int i = e.body % lanes;
      column[0][i] = e.n.x;
      column[1][i] = e.n.y;
      column[2][i] = e.n.z;
    }
  factor_groups();
  if (!chain_.links.empty()) {
    for (LinkChain::Link &l : chain_.links)
      for (LinkChain::End &e : l.end) {
        const Lane *column = b_.groups[e.body / lanes].link[e.slot];
        const int i = e.body % lanes;
        e.answer = {column[0][i], column[1][i], column[2][i]};
      }
    chain_.factor();
    for (int f = 0; f < nf; ++f)
      condense_links([&](int group) { return B_[group * nf + f].a; }, true);
  }
  condense_groups();
  if (!b_.bends.empty()) {
    lift_.find(b_);
    lift_.add_matrix(corner_apart_, border_.a);
  }
  border_.factor();
}

// Eliminates the link forces from columns already multiplied by A^-1.
template <class ColumnOf> void BearingSystem::condense_links(ColumnOf column, bool mark)
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
      BodyGroup &g = b_.groups[e.body / lanes];
      if (mark) g.coupled = true;
      Lane *x = column(e.body / lanes);
      const int lane = e.body % lanes, n = g.spins ? 6 : 3;
      const double f = k == 0 ? forces_[i] : -forces_[i];
      for (int m = 0; m < n; ++m) x[m][lane] -= f * g.link[e.slot][m][lane];
    }
}

RACEWAY_LANES void BearingSystem::solve()
{
  const int nf = b_.columns;
  std::fill(motions_apart_.begin(), motions_apart_.end(), 0.0);
  for (BodyGroup &g : b_.groups) {
    if (g.spins) substitute<6>(g.A, g.rhs);
    else substitute<3>(g.A, g.rhs);
  }
  if (!chain_.links.empty())
    condense_links([this](int group) { return b_.groups[group].rhs; }, false);
  if (nf == 0) return;
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    const BodyGroup &g = b_.groups[k];
    if (!g.coupled) continue;
    const int n = g.spins ? 6 : 3;
    const BearingBodies::GroupColumns &columns = b_.columns_of_group[k];
    for (const std::vector<int> *rows : {&columns.of_raceways, &columns.of_cages})
      for (int i : *rows) {
        Lane s = {};
        for (int m = 0; m < n; ++m) s += C_[k * nf + i].a[m] * g.rhs[m];
        motions_[i] -= sum(where(g.used, s, 0.0));
      }
  }
  if (!b_.bends.empty()) lift_.add_forces(motions_apart_, y_);
  border_.solve(y_.data());
  if (!b_.bends.empty()) lift_.find_motions(y_, motions_apart_);
  for (size_t k = 0; k < b_.groups.size(); ++k) {
    BodyGroup &g = b_.groups[k];
    if (!g.coupled) continue;
    const int n = g.spins ? 6 : 3;
    for (int f : b_.columns_of_group[k].all)
      for (int m = 0; m < n; ++m) g.rhs[m] -= B_[k * nf + f].a[m] * motions_[f];
  }
}

}    // namespace raceway
