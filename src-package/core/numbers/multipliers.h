// SPDX-License-Identifier: GPL-2.0-or-later
// Floquet multipliers of a periodic motion: the eigenvalues of the linear map A by which a small
// change at the start of a period becomes a change at its end.
//
// Changes and their images under A are known from a search for the orbit. With an orthonormal basis
// Q of the changes and its images B = A Q, the multipliers are approximated by the eigenvalues m of
// H = Q^T B (Ritz values, as in Arnoldi's method), and the error of each is estimated by the
// residual |B y - m Q y| of its eigenvector y, plus the error of B y if the images have errors of
// the size `noise`. A change that differs from the later ones only by a fraction `apart` is
// regarded as noise and omitted.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace raceway {

struct Multiplier {
  std::complex<double> value;
  double error = 0.0;
  double modulus() const { return std::abs(value); }                // what is left of a change
  double turn() const { return std::arg(value) / (2.0 * M_PI); }    // of the change, in turns
  double relative_error() const { return modulus() > 0.0 ? error / modulus() : HUGE_VAL; }
  bool known() const { return relative_error() <= 0.1; }
  bool stable() const { return modulus() + error < 1.0; }
  bool unstable() const { return known() && modulus() - error > 1.0; }
  bool whirls() const { return known() && value.imag() != 0.0; }
};

namespace multipliers_detail {

using Vector = std::vector<double>;
using Complex = std::complex<double>;
using Matrix = std::vector<std::vector<Complex>>;    // square

inline double dot(const Vector &a, const Vector &b)
{
  double sum = 0.0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Returns the roots of the characteristic polynomial: its coefficients by the method of Faddeev and
// Leverrier, its roots by that of Durand and Kerner. This is accurate enough for a few modes.
inline std::vector<Complex> eigenvalues(const Matrix &h)
{
  const size_t n = h.size();
  Matrix m(n, std::vector<Complex>(n, 0.0));
  std::vector<Complex> c(n + 1, 1.0);    // c[0] x^n + c[1] x^(n-1) + ...
  double size = 0.0;
  for (size_t k = 1; k <= n; ++k) {
    for (size_t i = 0; i < n; ++i) m[i][i] += c[k - 1];
    Matrix next(n, std::vector<Complex>(n, 0.0));
    Complex trace = 0.0;
    for (size_t i = 0; i < n; ++i) {
      for (size_t j = 0; j < n; ++j)
        for (size_t l = 0; l < n; ++l) next[i][j] += h[i][l] * m[l][j];
      trace += next[i][i];
    }
    m = next;
    c[k] = -trace / double(k);
    size = std::max(size, std::pow(std::abs(c[k]), 1.0 / double(k)));
  }
  std::vector<Complex> root(n, 0.0);
  if (size == 0.0) return root;
  for (size_t k = 0; k < n; ++k) root[k] = size * std::pow(Complex(0.4, 0.9), double(k + 1));
  for (int turn = 0; turn < 200; ++turn)
    for (size_t k = 0; k < n; ++k) {
      Complex value = c[0], others = 1.0;
      for (size_t j = 1; j <= n; ++j) value = value * root[k] + c[j];
      for (size_t j = 0; j < n; ++j)
        if (j != k) others *= root[k] - root[j];
      if (std::abs(others) > 0.0) root[k] -= value / others;
    }
  return root;
}

// Returns the eigenvector of length 1 that belongs to an eigenvalue, by inverse iteration.
inline std::vector<Complex> eigenvector(const Matrix &h, Complex value)
{
  const size_t n = h.size();
  double size = 0.0;
  for (const auto &row : h)
    for (const Complex one : row) size = std::max(size, std::abs(one));
  if (size == 0.0) size = 1.0;
  std::vector<Complex> y(n);
  for (size_t i = 0; i < n; ++i) y[i] = Complex(1.0, 0.3 * double(i));
  for (int turn = 0; turn < 3; ++turn) {
    Matrix a = h;
    for (size_t i = 0; i < n; ++i) a[i][i] -= value + Complex(1e-9, 1e-9) * size;
    for (size_t k = 0; k < n; ++k) {
      size_t pivot = k;
      for (size_t i = k; i < n; ++i)
        if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
      std::swap(a[k], a[pivot]);
      std::swap(y[k], y[pivot]);
      for (size_t i = k + 1; i < n; ++i) {
        const Complex share = a[i][k] / a[k][k];
        for (size_t j = k; j < n; ++j) a[i][j] -= share * a[k][j];
        y[i] -= share * y[k];
      }
    }
    double length = 0.0;
    for (size_t k = n; k-- > 0;) {
      for (size_t j = k + 1; j < n; ++j) y[k] -= a[k][j] * y[j];
      y[k] /= a[k][k];
      length += std::norm(y[k]);
    }
    for (Complex &one : y) one /= std::sqrt(length);
  }
  return y;
}

}    // namespace multipliers_detail

// Returns the multipliers, starting with that of the largest modulus. The changes and their images
// are given in order of importance, i.e. those closest to the orbit first.
inline std::vector<Multiplier> multipliers(const std::vector<std::vector<double>> &changes,
                                           const std::vector<std::vector<double>> &images,
                                           double noise = 0.0, double apart = 0.1)
{
  using namespace multipliers_detail;
  std::vector<Vector> basis, mapped;
  Vector wrong;    // errors of `mapped`
  for (size_t k = 0; k < changes.size(); ++k) {
    Vector q = changes[k], b = images[k];
    const double whole = std::sqrt(dot(q, q));
    double off = noise;
    for (size_t j = 0; j < basis.size(); ++j) {
      const double share = dot(basis[j], q);
      off += std::fabs(share) * wrong[j];
      for (size_t i = 0; i < q.size(); ++i) {
        q[i] -= share * basis[j][i];
        b[i] -= share * mapped[j][i];
      }
    }
    const double own = std::sqrt(dot(q, q));
    if (!(own > apart * whole)) continue;
    for (double &one : q) one /= own;
    for (double &one : b) one /= own;
    basis.push_back(q);
    mapped.push_back(b);
    wrong.push_back(off / own);
  }
  const size_t n = basis.size();
  if (n == 0) return {};
  Matrix h(n, std::vector<Complex>(n));
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) h[i][j] = dot(basis[i], mapped[j]);
  std::vector<Multiplier> all;
  for (const Complex value : eigenvalues(h)) {
    const std::vector<Complex> y = eigenvector(h, value);
    double error = 0.0;
    for (size_t i = 0; i < basis[0].size(); ++i) {
      Complex left = 0.0;
      for (size_t j = 0; j < n; ++j) left += y[j] * (mapped[j][i] - value * basis[j][i]);
      error += std::norm(left);
    }
    double from_noise = 0.0;
    for (size_t j = 0; j < n; ++j) from_noise += std::abs(y[j]) * wrong[j];
    const bool real = std::fabs(value.imag()) < 1e-6 * std::abs(value);
    if (std::isfinite(error))
      all.push_back({real ? Complex(value.real()) : value, std::sqrt(error) + from_noise});
  }
  std::sort(all.begin(), all.end(),
            [](const Multiplier &a, const Multiplier &b) { return a.modulus() > b.modulus(); });
  return all;
}

}    // namespace raceway
