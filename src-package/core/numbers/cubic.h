// SPDX-License-Identifier: GPL-2.0-or-later
// The cubic Hermite polynomial that matches positions and velocities at two instants h seconds
// apart, evaluated at the fraction s of the interval. Its error is at most h^4/384 times the fourth
// derivative of the position.
#pragma once

namespace raceway {

class Cubic {
 public:
  Cubic(double s, double h) :
      to_(s * s * (3.0 - 2.0 * s)), v_from_(h * s * (1.0 - s) * (1.0 - s)),
      v_to_(h * s * s * (s - 1.0))
  {
  }

  // double, Lane or Vec3
  template <class T>
  __attribute__((always_inline)) T operator()(const T &x_from, const T &v_from, const T &x_to,
                                              const T &v_to) const
  {
    return x_from + (x_to - x_from) * to_ + v_from * v_from_ + v_to * v_to_;
  }

 private:
  double to_, v_from_, v_to_;
};

}    // namespace raceway
