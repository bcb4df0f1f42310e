// SPDX-License-Identifier: GPL-2.0-or-later
// Three-component vector with the algebra needed for contacts and rings. T is double or Lane
// (lane.h).
#pragma once

#include "lane.h"

namespace raceway {

template <class T> struct alignas(sizeof(T)) Vec3T {
  T x = T(), y = T(), z = T();

  static RACEWAY_INLINE Vec3T from(const T *p) { return {p[0], p[1], p[2]}; }
  RACEWAY_INLINE void to(T *p) const
  {
    p[0] = x;
    p[1] = y;
    p[2] = z;
  }
  RACEWAY_INLINE void add_to(T *p) const
  {
    p[0] += x;
    p[1] += y;
    p[2] += z;
  }

  RACEWAY_INLINE Vec3T operator-() const { return {-x, -y, -z}; }
  RACEWAY_INLINE Vec3T operator+(const Vec3T &b) const { return {x + b.x, y + b.y, z + b.z}; }
  RACEWAY_INLINE Vec3T operator-(const Vec3T &b) const { return {x - b.x, y - b.y, z - b.z}; }
  template <class S> RACEWAY_INLINE Vec3T operator*(const S &s) const
  {
    return {s * x, s * y, s * z};
  }
  RACEWAY_INLINE Vec3T &operator+=(const Vec3T &b)
  {
    x += b.x;
    y += b.y;
    z += b.z;
    return *this;
  }
  RACEWAY_INLINE Vec3T &operator-=(const Vec3T &b)
  {
    x -= b.x;
    y -= b.y;
    z -= b.z;
    return *this;
  }
};

using Vec3 = Vec3T<double>;

RACEWAY_INLINE Vec3 operator*(double s, const Vec3 &a) { return a * s; }
template <class T> RACEWAY_INLINE T dot(const Vec3T<T> &a, const Vec3T<T> &b)
{
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> RACEWAY_INLINE Vec3T<T> cross(const Vec3T<T> &a, const Vec3T<T> &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> RACEWAY_INLINE T norm(const Vec3T<T> &a) { return square_root(dot(a, a)); }

// Rotates a about the rotation vector w (radians, right-handed) by Rodrigues' formula, which is
// exact.
inline Vec3 rotate(const Vec3 &a, const Vec3 &w)
{
  const double angle = norm(w);
  if (angle == 0.0) return a;
  const Vec3 k = w * (1.0 / angle);
  const double c = std::cos(angle), s = std::sin(angle);
  return a * c + cross(k, a) * s + k * (dot(k, a) * (1.0 - c));
}

}    // namespace raceway
