// SPDX-License-Identifier: GPL-2.0-or-later
// Drag on a ball that moves through a mixture of oil and air (docs/tribology, Drag). The drag force
// is C_D X rho A v^2/2 with A = pi R_b^2, where X is the volume fraction of oil. C_D is the drag
// coefficient of a sphere at Re = rho v 2R_b/eta. It is interpolated from a table on log-log axes,
// follows Stokes's law below Re = 0.1 and is constant above 1e5.
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

struct DragTable {
  static constexpr int size = 7;
  double x[size], bend[size], first;    // values of ln Re; change of slope at each of them; ln C_D
                                        // at the first
};

inline const DragTable &drag_table()
{
  static const DragTable table = [] {
    const double reynolds[] = {0.1, 1.0, 1e1, 1e2, 1e3, 1e4, 1e5};
    const double coefficient[] = {275.0, 30.0, 4.2, 1.2, 0.48, 0.40, 0.45};
    DragTable t;
    double slope = -1.0;
    for (int k = 0; k < DragTable::size; ++k) {
      t.x[k] = std::log(reynolds[k]);
      const double next = k + 1 < DragTable::size
                              ? (std::log(coefficient[k + 1]) - std::log(coefficient[k])) /
                                    (std::log(reynolds[k + 1]) - std::log(reynolds[k]))
                              : 0.0;
      t.bend[k] = next - slope;
      slope = next;
    }
    t.first = std::log(coefficient[0]);
    return t;
  }();
  return table;
}

template <class T> RACEWAY_INLINE T drag_coefficient(const DragTable &t, const T &reynolds)
{
  const T x = logarithm(reynolds);
  T y = t.first - (x - t.x[0]);
  for (int k = 0; k < DragTable::size; ++k)
    y = y + t.bend[k] * where(x > t.x[k], T(x - t.x[k]), 0.0);
  return exponential(y);
}

}    // namespace raceway
