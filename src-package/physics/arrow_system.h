// SPDX-License-Identifier: GPL-2.0-or-later
// Linear system of one implicit step of one bearing, solved in a time proportional to the number of balls.
//
// Unknowns: x_k of each body (6 for a ball: velocity and spin; 3 for a cage ball), y of the free degrees of freedom
// of the rings (the border), and one multiplier per closed contact between two bodies (a link):
//   A_k x_k + B_k y + sum_i s_ik n_i l_i = r_k        s_ik = +1 first, -1 second body of link i
//   sum_k C_k x_k + D y                  = r_y
//   l_i/a_i = n_i . (x_first - x_second)              a_i stiffness of the link in these units
// 1. Every body is condensed with its own 6x6 (3x3) block. 2. What is left of the links is a scalar chain: links
// share at most two bodies with others, ball, cage ball, ball, ..., so the chain is tridiagonal, with one corner
// where it closes to a circle; elimination carries that corner along. 3. The border, a few unknowns, is solved
// densely and everything is put back. Order of operations depends on the order of bodies and links only.
//
// Blocks are mass plus h C + h^2 k: their symmetric part is dominated by the mass where anything could be small,
// so elimination needs no pivots; the border has some.
#ifndef RACEWAY_ARROW_SYSTEM_H
#define RACEWAY_ARROW_SYSTEM_H

#include "contact_jacobian.h"

#include <algorithm>
#include <vector>

namespace raceway {

// In place L U of an n x n matrix, rows 6 apart, reciprocals of U's diagonal.
template <int n> inline void factor(double *a)
{
  for (int k = 0; k < n; ++k) {
    const double d = a[6 * k + k] = 1.0 / a[6 * k + k];
    for (int i = k + 1; i < n; ++i) {
      const double f = a[6 * i + k] *= d;
      for (int j = k + 1; j < n; ++j) a[6 * i + j] -= f * a[6 * k + j];
    }
  }
}

template <int n> inline void substitute(const double *a, double *x)
{
  for (int i = 1; i < n; ++i)
    for (int k = 0; k < i; ++k) x[i] -= a[6 * i + k] * x[k];
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) x[i] -= a[6 * i + k] * x[k];
    x[i] *= a[6 * i + i];
  }
}

class ArrowSystem {
 public:
  struct Block {
    int size = 6;          // 6 or 3
    double A[36];          // rows 6 apart
    double x[6];           // right-hand side, then solution
    int links = 0, link[2];
  };

  void resize(int bodies, int border)
  {
    block.resize(bodies);
    nf_ = border;
    B.assign(static_cast<size_t>(bodies) * border * 6, 0.0);
    C.assign(B.size(), 0.0);
    D.assign(static_cast<size_t>(border) * border, 0.0);
    y.assign(border, 0.0);
  }
  int border() const { return nf_; }

  void clear()
  {
    for (Block &b : block) {
      std::fill(b.A, b.A + 36, 0.0);
      b.links = 0;
    }
    std::fill(B.begin(), B.end(), 0.0);
    std::fill(C.begin(), C.end(), 0.0);
    std::fill(D.begin(), D.end(), 0.0);
    links_.clear();
  }

  double *column(int body, int j) { return &B[6 * (static_cast<size_t>(body) * nf_ + j)]; }
  double *row(int body, int j) { return &C[6 * (static_cast<size_t>(body) * nf_ + j)]; }

  // False if a body would have a third link: then it is no chain.
  bool link(int first, int second, const Vec3 &n, double a)
  {
    for (int k : {first, second}) {
      if (block[k].links == 2) return false;
      block[k].link[block[k].links++] = static_cast<int>(links_.size());
    }
    links_.push_back(Link());
    Link &l = links_.back();
    l.body[0] = first;
    l.body[1] = second;
    n.to(l.n);
    l.inverse = 1.0 / a;
    return true;
  }

  void solve()
  {
    for (size_t k = 0; k < block.size(); ++k) {
      Block &b = block[k];
      if (b.size == 6) {
        factor<6>(b.A);
        substitute<6>(b.A, b.x);
        for (int j = 0; j < nf_; ++j) substitute<6>(b.A, column(k, j));
      } else {
        factor<3>(b.A);
        substitute<3>(b.A, b.x);
        for (int j = 0; j < nf_; ++j) substitute<3>(b.A, column(k, j));
      }
    }
    if (!links_.empty()) solve_links();
    solve_border();
  }

  std::vector<Block> block;
  std::vector<double> B, C;    // per body and border unknown, 6 values: a column of B_k, a row of C_k
  std::vector<double> D, y;    // y: right-hand side, then solution

 private:
  struct Link {
    int body[2];
    double n[3], inverse;
    double P[2][6];       // A_k^-1 n of both bodies
    bool done = false;
  };

  // The other link at this end of a link, or -1.
  int neighbour(int i, int end) const
  {
    const Block &b = block[links_[i].body[end]];
    return b.links < 2 ? -1 : b.link[0] == i ? b.link[1] : b.link[0];
  }

  // n_i . P of link j at the body of end `end` of link i, with both signs.
  double coupling(int i, int end, int j) const
  {
    const int k = links_[i].body[end], other = links_[j].body[0] == k ? 0 : 1;
    const double *n = links_[i].n, *P = links_[j].P[other];
    const double d = n[0] * P[0] + n[1] * P[1] + n[2] * P[2];
    return end == other ? d : -d;
  }

  void solve_links()
  {
    for (Link &l : links_)
      for (int end = 0; end < 2; ++end) {
        const Block &b = block[l.body[end]];
        double *P = l.P[end];
        for (int k = 0; k < 6; ++k) P[k] = k < 3 ? l.n[k] : 0.0;
        if (b.size == 6) substitute<6>(b.A, P);
        else substitute<3>(b.A, P);
      }
    const int width = 1 + nf_, n = static_cast<int>(links_.size());
    rhs_.resize(static_cast<size_t>(n) * width);
    // open chains first, from their ends; what is left are circles
    for (int pass = 0; pass < 2; ++pass)
      for (int i = 0; i < n; ++i) {
        if (links_[i].done) continue;
        const int a = neighbour(i, 0), b = neighbour(i, 1);
        if (pass == 0 && a >= 0 && b >= 0) continue;
        walk(i, a < 0 ? 1 : b < 0 ? 0 : 1);
        solve_chain(pass == 1, width);
      }
    // back into the columns of the bodies
    for (int i = 0; i < n; ++i)
      for (int end = 0; end < 2; ++end) {
        const int k = links_[i].body[end];
        const double s = end == 0 ? 1.0 : -1.0, *P = links_[i].P[end];
        for (int c = 0; c < width; ++c) {
          double *x = c == 0 ? block[k].x : column(k, c - 1);
          const double f = s * rhs_[i * width + c];
          for (int m = 0; m < block[k].size; ++m) x[m] -= f * P[m];
        }
      }
  }

  // Links of a chain in order into chain_, leaving link `i` by its end `end`.
  void walk(int i, int end)
  {
    chain_.clear();
    exit_.clear();
    while (i >= 0 && !links_[i].done) {
      links_[i].done = true;
      chain_.push_back(i);
      exit_.push_back(end);
      const int next = neighbour(i, end), shared = links_[i].body[end];
      if (next >= 0) end = links_[next].body[0] == shared ? 1 : 0;
      i = next;
    }
  }

  void solve_chain(bool circle, int width)
  {
    const int m = static_cast<int>(chain_.size());
    d_.resize(m);
    up_.assign(m, 0.0);
    low_.assign(m, 0.0);
    col_.assign(m, 0.0);
    row_.assign(m, 0.0);
    for (int q = 0; q < m; ++q) {
      const int i = chain_[q];
      const Link &l = links_[i];
      d_[q] = l.inverse + coupling(i, 0, i) + coupling(i, 1, i);
      if (q + 1 < m) {
        up_[q] = coupling(i, exit_[q], chain_[q + 1]);
        low_[q + 1] = coupling(chain_[q + 1], 1 - exit_[q + 1], i);
      }
      for (int c = 0; c < width; ++c) {
        const double *p = c == 0 ? block[l.body[0]].x : column(l.body[0], c - 1);
        const double *s = c == 0 ? block[l.body[1]].x : column(l.body[1], c - 1);
        rhs_[i * width + c] = l.n[0] * (p[0] - s[0]) + l.n[1] * (p[1] - s[1]) + l.n[2] * (p[2] - s[2]);
      }
    }
    const int last = m - 1;
    if (circle && m > 1) {
      row_[0] += coupling(chain_[last], exit_[last], chain_[0]);
      col_[0] += coupling(chain_[0], 1 - exit_[0], chain_[last]);
    }
    if (m > 1) {
      row_[last - 1] += low_[last];
      col_[last - 1] += up_[last - 1];
    }
    for (int q = 0; q < last; ++q) {
      const double inv = 1.0 / d_[q];
      const double *from = &rhs_[chain_[q] * width];
      if (q + 1 < last) {
        const double f = low_[q + 1] * inv, g = row_[q] * inv;
        d_[q + 1] -= f * up_[q];
        col_[q + 1] -= f * col_[q];
        row_[q + 1] -= g * up_[q];
        for (int c = 0; c < width; ++c) rhs_[chain_[q + 1] * width + c] -= f * from[c];
      }
      const double g = row_[q] * inv;
      d_[last] -= g * col_[q];
      for (int c = 0; c < width; ++c) rhs_[chain_[last] * width + c] -= g * from[c];
    }
    for (int q = last; q >= 0; --q)
      for (int c = 0; c < width; ++c) {
        double &v = rhs_[chain_[q] * width + c];
        if (q < last) {
          v -= col_[q] * rhs_[chain_[last] * width + c];
          if (q + 1 < last) v -= up_[q] * rhs_[chain_[q + 1] * width + c];
        }
        v /= d_[q];
      }
  }

  void solve_border()
  {
    if (nf_ == 0) return;
    for (size_t k = 0; k < block.size(); ++k)
      for (int i = 0; i < nf_; ++i) {
        const double *c = row(k, i);
        const int n = block[k].size;
        double s = 0.0;
        for (int m = 0; m < n; ++m) s += c[m] * block[k].x[m];
        y[i] -= s;
        for (int j = 0; j < nf_; ++j) {
          const double *b = column(k, j);
          s = 0.0;
          for (int m = 0; m < n; ++m) s += c[m] * b[m];
          D[i * nf_ + j] -= s;
        }
      }
    for (int k = 0; k < nf_; ++k) {
      int p = k;
      for (int i = k + 1; i < nf_; ++i)
        if (std::fabs(D[i * nf_ + k]) > std::fabs(D[p * nf_ + k])) p = i;
      if (p != k) {
        for (int j = 0; j < nf_; ++j) std::swap(D[k * nf_ + j], D[p * nf_ + j]);
        std::swap(y[k], y[p]);
      }
      for (int i = k + 1; i < nf_; ++i) {
        const double f = D[i * nf_ + k] / D[k * nf_ + k];
        for (int j = k + 1; j < nf_; ++j) D[i * nf_ + j] -= f * D[k * nf_ + j];
        y[i] -= f * y[k];
      }
    }
    for (int i = nf_ - 1; i >= 0; --i) {
      for (int j = i + 1; j < nf_; ++j) y[i] -= D[i * nf_ + j] * y[j];
      y[i] /= D[i * nf_ + i];
    }
    for (size_t k = 0; k < block.size(); ++k)
      for (int j = 0; j < nf_; ++j) {
        const double *b = column(k, j);
        for (int m = 0; m < block[k].size; ++m) block[k].x[m] -= b[m] * y[j];
      }
  }

  int nf_ = 0;
  std::vector<Link> links_;
  std::vector<int> chain_, exit_;
  std::vector<double> rhs_, d_, up_, low_, col_, row_;
};

}    // namespace raceway

#endif
