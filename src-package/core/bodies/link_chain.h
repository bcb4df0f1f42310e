// SPDX-License-Identifier: GPL-2.0-or-later
// Treats closed contacts between bodies (ball, cage ball, ball, ...) as a chain of links with one
// scalar unknown each.
//
// Link i joins two bodies along the unit normal n_i with the stiffness a_i. Once the blocks A of
// all bodies have been eliminated, the forces l of the links solve
//   l_i/a_i + sum_j c_ij l_j = n_i . (x_first - x_second)
// where c_ij = +-n_i . A^-1 n_j at a body that is shared by i and j. A link shares at most two
// bodies with other links, so c is tridiagonal, with one additional corner entry if a chain closes
// into a circle; elimination carries that corner along. The order of operations depends only on the
// order of the links.
#pragma once

#include "../numbers/vec3.h"

#include <vector>

namespace raceway {

class LinkChain {
 public:
  struct End {
    int body;
    Vec3 n;         // normal of the link in the body's frame
    Vec3 answer;    // velocity of the body due to a unit force along n, i.e. the first three
                    // entries of A^-1 n
    int slot;       // 0 if it is the first link of the body, 1 if it is the second
  };
  struct Link {
    End end[2];
    double inverse;    // 1/a
  };

  void resize(int bodies) { of_body_.assign(bodies, Pair()); }
  void clear()
  {
    for (const Link &l : links)
      for (const End &e : l.end) of_body_[e.body].count = 0;
    links.clear();
  }

  // Adds a link. Returns false if a body would have a third link, because the links would then no
  // longer form a chain.
  bool add(int first, int second, const Vec3 &n_first, const Vec3 &n_second, double a)
  {
    const int slot[2] = {of_body_[first].count, of_body_[second].count};
    if (slot[0] == 2 || slot[1] == 2) return false;
    const int i = static_cast<int>(links.size());
    for (int k = 0; k < 2; ++k) {
      Pair &p = of_body_[k == 0 ? first : second];
      p.link[p.count++] = i;
    }
    links.push_back(
        {{{first, n_first, Vec3(), slot[0]}, {second, n_second, Vec3(), slot[1]}}, 1.0 / a});
    return true;
  }

  // Must be called after the answers at both ends of every link have been set.
  void factor()
  {
    const int n = static_cast<int>(links.size());
    chains_.clear();
    order_.clear();
    exit_.clear();
    done_.assign(n, false);
    for (int pass = 0; pass < 2;
         ++pass)    // open chains first, from their ends; all remaining chains are circles
      for (int i = 0; i < n; ++i) {
        if (done_[i]) continue;
        const bool open_0 = neighbour(i, 0) < 0, open_1 = neighbour(i, 1) < 0;
        if (pass == 0 && !open_0 && !open_1) continue;
        const int first = static_cast<int>(order_.size());
        walk(i, open_0 || !open_1 ? 1 : 0);
        chains_.push_back({first, static_cast<int>(order_.size()), pass == 1});
      }
    for (std::vector<double> *v : {&inv_, &up_, &low_, &col_, &row_}) v->assign(n, 0.0);
    for (const Chain &c : chains_) factor(c);
  }

  // Replaces the right-hand sides by the forces in place. Both are indexed by link.
  void solve(double *x) const
  {
    for (const Chain &c : chains_) {
      const int last = c.end - 1;
      for (int q = c.begin; q < last; ++q) {
        if (q + 1 < last) x[order_[q + 1]] -= low_[q + 1] * x[order_[q]];
        x[order_[last]] -= row_[q] * x[order_[q]];
      }
      for (int q = last; q >= c.begin; --q) {
        double &v = x[order_[q]];
        if (q < last) {
          v -= col_[q] * x[order_[last]];
          if (q + 1 < last) v -= up_[q] * x[order_[q + 1]];
        }
        v *= inv_[q];
      }
    }
  }

  std::vector<Link> links;

 private:
  struct Pair {
    int count = 0, link[2];
  };
  struct Chain {
    int begin, end;
    bool circle;
  };

  // Returns the other link of the body at the given end of link i, or -1 if there is none.
  int neighbour(int i, int end) const
  {
    const Pair &p = of_body_[links[i].end[end].body];
    return p.count < 2 ? -1 : p.link[0] == i ? p.link[1] : p.link[0];
  }

  void walk(int i, int end)
  {
    while (i >= 0 && !done_[i]) {
      done_[i] = true;
      order_.push_back(i);
      exit_.push_back(end);
      const int next = neighbour(i, end), shared = links[i].end[end].body;
      if (next >= 0) end = links[next].end[0].body == shared ? 1 : 0;
      i = next;
    }
  }

  // Returns c_ij at the body at end `end` of link i.
  double coupling(int i, int end, int j) const
  {
    const End &e = links[i].end[end];
    const int other = links[j].end[0].body == e.body ? 0 : 1;
    const double d = dot(e.n, links[j].end[other].answer);
    return end == other ? d : -d;
  }

  // After factor(), low_ and row_ contain multipliers and inv_ contains reciprocal pivots.
  void factor(const Chain &c)
  {
    const int last = c.end - 1;
    for (int q = c.begin; q < c.end; ++q) {
      const int i = order_[q];
      inv_[q] = links[i].inverse + coupling(i, 0, i) + coupling(i, 1, i);
      if (q < last) {
        up_[q] = coupling(i, exit_[q], order_[q + 1]);
        low_[q + 1] = coupling(order_[q + 1], 1 - exit_[q + 1], i);
      }
    }
    if (last > c.begin) {
      if (c.circle) {
        row_[c.begin] += coupling(order_[last], exit_[last], order_[c.begin]);
        col_[c.begin] += coupling(order_[c.begin], 1 - exit_[c.begin], order_[last]);
      }
      row_[last - 1] += low_[last];
      col_[last - 1] += up_[last - 1];
    }
    for (int q = c.begin; q < last; ++q) {
      inv_[q] = 1.0 / inv_[q];
      row_[q] *= inv_[q];
      if (q + 1 < last) {
        low_[q + 1] *= inv_[q];
        inv_[q + 1] -= low_[q + 1] * up_[q];
        col_[q + 1] -= low_[q + 1] * col_[q];
        row_[q + 1] -= row_[q] * up_[q];
      }
      inv_[last] -= row_[q] * col_[q];
    }
    inv_[last] = 1.0 / inv_[last];
  }

  std::vector<Pair> of_body_;
  std::vector<Chain> chains_;
  std::vector<int> order_, exit_;
  std::vector<char> done_;
  std::vector<double> inv_, up_, low_, col_, row_;
};

}    // namespace raceway
