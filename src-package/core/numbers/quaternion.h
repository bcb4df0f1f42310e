// SPDX-License-Identifier: GPL-2.0-or-later
// A rotation from the body axes to the observer's axes, represented by a unit quaternion.
#pragma once

#include "vec3.h"

namespace raceway {

struct Quaternion {
  double w = 1.0;
  Vec3 v;

  // Returns the rotation by the rotation vector a (rad).
  static Quaternion by(const Vec3 &a)
  {
    const double angle = norm(a), half = 0.5 * angle;
    const double share = angle > 1e-8 ? std::sin(half) / angle : 0.5;
    return {std::cos(half), a * share};
  }

  // Returns the rotation that applies b first and then this one.
  Quaternion operator*(const Quaternion &b) const
  {
    return {w * b.w - dot(v, b.v), b.v * w + v * b.w + cross(v, b.v)};
  }
  Quaternion back() const { return {w, -v}; }
  Vec3 operator()(const Vec3 &a) const
  {
    const Vec3 t = cross(v, a) * 2.0;
    return a + t * w + cross(v, t);
  }
  Quaternion normal() const
  {
    const double inverse = 1.0 / std::sqrt(w * w + dot(v, v));
    return {w * inverse, v * inverse};
  }
  // Returns the rotation vector of the shorter rotation, rad.
  Vec3 vector() const
  {
    const double sine = norm(v), side = w < 0.0 ? -1.0 : 1.0;
    const double share = sine > 1e-8 ? 2.0 * std::atan2(sine, side * w) / sine : 2.0;
    return v * (side * share);
  }
};

}    // namespace raceway
