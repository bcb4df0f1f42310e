// SPDX-License-Identifier: GPL-2.0-or-later
// Three-component vector, just enough algebra for contacts and rings.
#ifndef RACEWAY_VEC3_H
#define RACEWAY_VEC3_H

#include <cmath>

namespace raceway {

struct Vec3 {
  double x = 0.0, y = 0.0, z = 0.0;

  static Vec3 from(const double *p) { return {p[0], p[1], p[2]}; }
  void to(double *p) const { p[0] = x; p[1] = y; p[2] = z; }
  void add_to(double *p) const { p[0] += x; p[1] += y; p[2] += z; }

  Vec3 operator-() const { return {-x, -y, -z}; }
  Vec3 operator+(const Vec3 &b) const { return {x + b.x, y + b.y, z + b.z}; }
  Vec3 operator-(const Vec3 &b) const { return {x - b.x, y - b.y, z - b.z}; }
  Vec3 operator*(double s) const { return {s * x, s * y, s * z}; }
  Vec3 &operator+=(const Vec3 &b) { x += b.x; y += b.y; z += b.z; return *this; }
  Vec3 &operator-=(const Vec3 &b) { x -= b.x; y -= b.y; z -= b.z; return *this; }
};

inline Vec3 operator*(double s, const Vec3 &a) { return a * s; }
inline double dot(const Vec3 &a, const Vec3 &b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3 &a, const Vec3 &b)
{
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3 &a) { return std::sqrt(dot(a, a)); }

// Rotate a about the rotation vector w (radians, right-handed): Rodrigues' formula, exact.
inline Vec3 rotate(const Vec3 &a, const Vec3 &w)
{
  const double angle = norm(w);
  if (angle == 0.0) return a;
  const Vec3 k = w * (1.0 / angle);
  const double c = std::cos(angle), s = std::sin(angle);
  return a * c + cross(k, a) * s + k * (dot(k, a) * (1.0 - c));
}

}    // namespace raceway

#endif
