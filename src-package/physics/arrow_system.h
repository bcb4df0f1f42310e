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

// Solves for `width` right-hand sides side by side: rows of x are `stride` apart.
template <int n, int width> inline void substitute(const double *a, double *x, int stride)
{
  for (int i = 1; i < n; ++i)
    for (int k = 0; k < i; ++k)
      for (int c = 0; c < width; ++c) x[i * stride + c] -= a[6 * i + k] * x[k * stride + c];
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k)
      for (int c = 0; c < width; ++c) x[i * stride + c] -= a[6 * i + k] * x[k * stride + c];
    for (int c = 0; c < width; ++c) x[i * stride + c] *= a[6 * i + i];
  }
}

template <int n> inline void substitute(const double *a, double *x, int width)
{
  switch (width) {
    case 1: return substitute<n, 1>(a, x, width);
    case 2: return substitute<n, 2>(a, x, width);
    case 3: return substitute<n, 3>(a, x, width);
    case 4: return substitute<n, 4>(a, x, width);
    case 6: return substitute<n, 6>(a, x, width);
  }
  for (int c = 0; c < width; ++c) substitute<n, 1>(a, x + c, width);
}

class ArrowSystem {
 public:
  struct Block {
    int size = 6;          // 6 or 3
    double A[36];          // rows 6 apart
    int links = 0, link[2];
    bool coupled = false;  // to the border, directly or through a link
  };

  void resize(int bodies, int border)
  {
    block.resize(bodies);
    nf_ = border;
    width_ = 1 + border;
    X.assign(static_cast<size_t>(bodies) * width_ * 6, 0.0);
    C.assign(static_cast<size_t>(bodies) * border * 6, 0.0);
    D.assign(static_cast<size_t>(border) * border, 0.0);
    y.assign(border, 0.0);
  }

  void clear()
  {
    for (Block &b : block) {
      std::fill(b.A, b.A + 36, 0.0);
      b.links = 0;
      b.coupled = false;
    }
    std::fill(X.begin(), X.end(), 0.0);
    std::fill(C.begin(), C.end(), 0.0);
    std::fill(D.begin(), D.end(), 0.0);
    links_.clear();
  }

  // Row m of body k in [right-hand side, then solution | B_k]; row of C_k for border unknown j (6 values).
  double *x(int k, int m) { return &X[width_ * (6 * static_cast<size_t>(k) + m)]; }
  double *row(int k, int j) { return &C[6 * (static_cast<size_t>(k) * nf_ + j)]; }
  void add_rhs(int k, const Vec3 &v, int first = 0)
  {
    x(k, first)[0] += v.x;
    x(k, first + 1)[0] += v.y;
    x(k, first + 2)[0] += v.z;
  }
  void add_column(int k, int j, const Vec3 &v, int first = 0)
  {
    x(k, first)[1 + j] += v.x;
    x(k, first + 1)[1 + j] += v.y;
    x(k, first + 2)[1 + j] += v.z;
  }
  Vec3 solution(int k, int first = 0) { return {x(k, first)[0], x(k, first + 1)[0], x(k, first + 2)[0]}; }

  // False if a body would have a third link: then it is no chain.
  bool link(int first, int second, const Vec3 &n, double a)
  {
    for (int k : {first, second}) {
      if (block[k].links == 2) return false;
      block[k].coupled = true;
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
        if (b.coupled) substitute<6>(b.A, x(k, 0), width_);
        else substitute<6, 1>(b.A, x(k, 0), width_);
      } else {
        factor<3>(b.A);
        if (b.coupled) substitute<3>(b.A, x(k, 0), width_);
        else substitute<3, 1>(b.A, x(k, 0), width_);
      }
    }
    if (!links_.empty()) solve_links();
    if (nf_ > 0) solve_border();
  }

  std::vector<Block> block;
  std::vector<double> X, C;    // per body, see x() and row()
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
        if (b.size == 6) substitute<6, 1>(b.A, P, 1);
        else substitute<3, 1>(b.A, P, 1);
      }
    const int width = width_, n = static_cast<int>(links_.size());
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
        for (int m = 0; m < block[k].size; ++m)
          for (int c = 0; c < width; ++c) x(k, m)[c] -= s * P[m] * rhs_[i * width + c];
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
      const double *p = x(l.body[0], 0), *s = x(l.body[1], 0);
      for (int c = 0; c < width; ++c)
        rhs_[i * width + c] = l.n[0] * (p[c] - s[c]) + l.n[1] * (p[width + c] - s[width + c]) +
            l.n[2] * (p[2 * width + c] - s[2 * width + c]);
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
    for (size_t k = 0; k < block.size(); ++k)
      for (int i = 0; block[k].coupled && i < nf_; ++i) {
        const double *c = row(k, i);
        for (int m = 0; m < block[k].size; ++m) {
          if (c[m] == 0.0) continue;
          const double *b = x(k, m);
          y[i] -= c[m] * b[0];
          for (int j = 0; j < nf_; ++j) D[i * nf_ + j] -= c[m] * b[1 + j];
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
      for (int m = 0; block[k].coupled && m < block[k].size; ++m) {
        double *b = x(k, m);
        for (int j = 0; j < nf_; ++j) b[0] -= b[1 + j] * y[j];
      }
  }

  int nf_ = 0, width_ = 1;
  std::vector<Link> links_;
  std::vector<int> chain_, exit_;
  std::vector<double> rhs_, d_, up_, low_, col_, row_;
};

}    // namespace raceway

#endif
