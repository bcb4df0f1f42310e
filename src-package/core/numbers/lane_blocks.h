// SPDX-License-Identifier: GPL-2.0-or-later
// Solves small dense systems, four at a time, by LU decomposition without pivoting and by
// substitution. The row stride is 6. Precondition: the symmetric part of each matrix is positive
// definite (mass + h C + h^2 k), so no pivot can vanish.
#pragma once

#include "lane.h"

namespace raceway {

// Factors the matrix in place. The reciprocals of the diagonal elements of U are stored.
template <int n> RACEWAY_INLINE void factor(Lane *a)
{
  for (int k = 0; k < n; ++k) {
    const Lane d = a[6 * k + k] = 1.0 / a[6 * k + k];
    for (int i = k + 1; i < n; ++i) {
      const Lane f = a[6 * i + k] *= d;
      for (int j = k + 1; j < n; ++j) a[6 * i + j] -= f * a[6 * k + j];
    }
  }
}

template <int n> RACEWAY_INLINE void substitute(const Lane *a, Lane *x)
{
  for (int i = 1; i < n; ++i)
    for (int k = 0; k < i; ++k) x[i] -= a[6 * i + k] * x[k];
  for (int i = n - 1; i >= 0; --i) {
    for (int k = i + 1; k < n; ++k) x[i] -= a[6 * i + k] * x[k];
    x[i] *= a[6 * i + i];
  }
}

}    // namespace raceway
