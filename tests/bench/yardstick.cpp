// SPDX-License-Identifier: GPL-2.0-or-later
// A fixed amount of work, similar to that in the contact law and the Newton iteration: powers,
// roots and small linear systems. The pages of `make bench` state the time it takes, so that pages
// from different days and machines can be compared by dividing their times by it.

#include <chrono>
#include <cmath>
#include <cstdio>

namespace {

constexpr int N = 6, ROUNDS = 1'000'000;

// Solve a diagonally dominant system in place by Gaussian elimination without pivoting.
double solved(double (&a)[N][N], double (&b)[N])
{
  for (int k = 0; k < N; ++k)
    for (int i = k + 1; i < N; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (int j = k; j < N; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (int i = N - 1; i >= 0; --i) {
    for (int j = i + 1; j < N; ++j) b[i] -= a[i][j] * b[j];
    b[i] /= a[i][i];
  }
  return b[0];
}

}    // namespace

int main()
{
  const auto begin = std::chrono::steady_clock::now();
  double x = 1.0;
  for (int n = 0; n < ROUNDS; ++n) {
    double a[N][N], b[N];
    for (int i = 0; i < N; ++i) {
      b[i] = std::pow(x, 1.5) + i;
      for (int j = 0; j < N; ++j) a[i][j] = i == j ? 10.0 + x : std::sqrt(x + i) / (1.0 + j);
    }
    x = 1.0 + std::fabs(solved(a, b));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  std::printf("%.4f %.15g\n", seconds.count(), x);    // x is used, so the work is done
}
