// SPDX-License-Identifier: GPL-2.0-or-later
// Anderson acceleration for the fixed point x = g(x) of a map that is expensive to evaluate.
//
// D. G. Anderson, J. ACM 12 (1965) 547; type II as in H. F. Walker and P. Ni, SIAM J. Numer. Anal.
// 49 (2011) 1715. If f = g(x) - x are the residuals at the most recent starts, the next start is
//   g_k - sum_j c_j (g_j+1 - g_j),   c: least squares of f_k - sum_j c_j (f_j+1 - f_j),
// which is equivalent to GMRES for an affine map: each slowly decaying mode requires one more
// evaluation of the map. Residuals and displacements are measured in the weighted norm sqrt(sum
// (w_i y_i)^2). A difference between residuals that is a linear combination of later differences,
// except for a fraction `apart`, is regarded as noise and omitted. A difference below `flat` times
// the residual is omitted as well: if residuals hardly depend on the start, the next start is
// placed further along the residuals.
#pragma once

#include "multipliers.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace raceway {

class FixedPoint {
 public:
  using Vector = std::vector<double>;
  struct Settings {
    size_t memory = 5;      // number of starts that are stored
    double reach = 0.1;     // largest displacement from g_k, in the norm
    double apart = 1e-2;    // smallest linearly independent fraction of a difference
    double flat = 0.02;     // smallest difference relative to the residual
    double noise = 0.0;     // error of a value of the map, in the norm
  };
  struct Next {
    Vector start;
    double residual = HUGE_VAL;    // norm of f_k
    // norm of the distance from x_k to the fixed point of the affine map through the stored values;
    // infinite if there is only one start
    double distance = HUGE_VAL;
  };

  FixedPoint() = default;
  FixedPoint(const Settings &set, Vector weights) : set_(set), weights_(std::move(weights)) {}
  bool begun() const { return !weights_.empty(); }

  // Adds a start x and the value g of the map at x.
  void add(Vector x, Vector g)
  {
    x_.push_back(std::move(x));
    g_.push_back(std::move(g));
    if (x_.size() <= set_.memory) return;
    x_.erase(x_.begin());
    g_.erase(g_.begin());
    if (first_ > 0) --first_;
  }

  // Chooses later starts without those up to now, except for the last.
  void forget() { first_ = x_.empty() ? 0 : x_.size() - 1; }

  // Returns the component of the last residual along the previous one, as a fraction of the
  // previous one, or 0 if there is only one start.
  double contraction() const
  {
    if (x_.size() - first_ < 2) return 0.0;
    const Vector f = residual(x_.size() - 1), before = residual(x_.size() - 2);
    const double whole = dot(before, before);
    return whole > 0.0 ? dot(f, before) / whole : 0.0;
  }

  Next next() const
  {
    Next to;
    const size_t last = x_.size() - 1, n = weights_.size();
    Vector f = residual(last), move(n, 0.0);
    to.residual = norm(f);
    std::vector<Vector> basis, images;    // orthonormal differences of f; equal combinations of g
    for (size_t j = last; j-- > first_;) {
      Vector df = difference(residual(j + 1), residual(j)), dg = difference(g_[j + 1], g_[j]);
      const double whole = norm(df);
      if (!(whole >= set_.flat * to.residual)) {
        if (j + 1 == last) break;
        continue;
      }
      for (size_t b = 0; b < basis.size(); ++b) {
        const double share = dot(basis[b], df);
        subtract(df, share, basis[b]);
        subtract(dg, share, images[b]);
      }
      const double own = norm(df);
      if (!(own > set_.apart * whole)) continue;
      for (size_t i = 0; i < n; ++i) {
        df[i] /= own;
        dg[i] /= own;
      }
      basis.push_back(std::move(df));
      images.push_back(std::move(dg));
    }
    for (size_t b = 0; b < basis.size(); ++b) subtract(move, dot(basis[b], f), images[b]);
    if (basis.empty() && last > first_) {
      // sum of all further residuals if each is smaller than the previous one by that factor
      const double share = contraction(), sum = share < 1.0 ? share / (1.0 - share) : HUGE_VAL;
      subtract(move, -std::min(sum, 2.0 * set_.reach / to.residual), f);
      to.distance = to.residual * (1.0 + sum);
    } else if (last > first_) {
      Vector way = f;
      subtract(way, -1.0, move);
      to.distance = norm(way);
    }
    const double length = norm(move), part = length > set_.reach ? set_.reach / length : 1.0;
    to.start = g_[last];
    subtract(to.start, -part, move);
    return to;
  }

  // Returns the multipliers of the map. They are estimated from the differences between the stored
  // starts, from the last differences that determine the largest multiplier to 1 % or, if there are
  // none, from those that determine it best: the very last ones may be too small.
  std::vector<Multiplier> multipliers() const
  {
    std::vector<Vector> changes, images;
    for (size_t j = x_.empty() ? 0 : x_.size() - 1; j-- > 0;) {
      changes.push_back(weighted(difference(x_[j + 1], x_[j])));
      images.push_back(weighted(difference(g_[j + 1], g_[j])));
    }
    std::vector<Multiplier> best;
    while (!changes.empty() && !(!best.empty() && best[0].relative_error() <= 1e-2)) {
      const std::vector<Multiplier> found = raceway::multipliers(changes, images, set_.noise);
      if (!found.empty() && (best.empty() || found[0].relative_error() < best[0].relative_error()))
        best = found;
      changes.erase(changes.begin());
      images.erase(images.begin());
    }
    return best;
  }

  // Names all data for a restart file (number_list.h).
  template <class List> void keep(List &list)
  {
    size_t n = weights_.size(), starts = x_.size();
    list(n, starts, first_);
    weights_.resize(n);
    for (std::vector<Vector> *of : {&x_, &g_}) of->resize(starts, Vector(n));
    list(weights_, x_, g_);
  }

 private:
  static Vector difference(const Vector &a, const Vector &b)
  {
    Vector d(a.size());
    for (size_t i = 0; i < a.size(); ++i) d[i] = a[i] - b[i];
    return d;
  }
  static void subtract(Vector &from, double times, const Vector &v)
  {
    for (size_t i = 0; i < v.size(); ++i) from[i] -= times * v[i];
  }
  Vector weighted(Vector v) const
  {
    for (size_t i = 0; i < v.size(); ++i) v[i] *= weights_[i];
    return v;
  }
  Vector residual(size_t k) const { return difference(g_[k], x_[k]); }
  double dot(const Vector &a, const Vector &b) const
  {
    double sum = 0.0;
    for (size_t i = 0; i < a.size(); ++i) sum += weights_[i] * weights_[i] * a[i] * b[i];
    return sum;
  }
  double norm(const Vector &v) const { return std::sqrt(dot(v, v)); }

  Settings set_;
  Vector weights_;
  std::vector<Vector> x_, g_;
  size_t first_ = 0;    // number of starts that next() ignores
};

}    // namespace raceway
