// SPDX-License-Identifier: GPL-2.0-or-later
// Position of a ball in the torus groove of a ring, at any contact angle and ring tilt.
//
// Law (docs/theory, Geometry; Farah 2020 fig. 4): the centres of curvature of the groove lie on a
// circle of radius rho about the ring axis e. With d = ball centre - ring centre, z = d.e, r = |d -
// z e|, u = (d - z e)/r, the ball's distance from that circle is s = |(r - rho) u + z e| and
//   overlap = s - (r_c - R_b),   normal n = ((r - rho) u + z e)/s  (ball -> raceway).
// The same expression applies to both rings: rho lies outside the ball path for the inner ring
// (n points to the axis) and inside it for the outer ring.
//
// The local frame consists of u (radial), t = e x u (circumferential, rolling), e (axial); w = n x
// t. Preconditions: r > 0 (a ball on the axis has no azimuth), r_c > R_b.
#pragma once

#include "../numbers/vec3.h"

namespace raceway {

enum class Side { inner = 0, outer = 1 };

struct Groove {
  Side side = Side::inner;
  double raceway_radius = 0.0;    // m, R_i or R_e, radius at the bottom of the groove
  double groove_radius = 0.0;     // m, r_c, radius of the cross-section
  double ball_radius = 0.0;       // m, R_b
  double offset = 0.0;            // m, axial distance from the ring's mid-plane to the groove
                                  // centres

  // Returns the radius of the circle of groove centres, m.
  double centre_circle() const
  {
    return side == Side::inner ? raceway_radius + groove_radius : raceway_radius - groove_radius;
  }
  // Returns the distance of the ball centre from that circle at which the surfaces touch, m.
  double slack() const { return groove_radius - ball_radius; }
  // These refer to a ball in the ring's mid-plane that touches an offset groove: the cosine of its
  // contact angle, and the bottom radius (m) of an equivalent groove in the mid-plane.
  double middle_cosine() const
  {
    const double sine = offset / slack();
    return std::sqrt(1.0 - sine * sine);
  }
  double middle_radius() const
  {
    if (offset == 0.0) return raceway_radius;
    const double rise = slack() * (1.0 - middle_cosine());
    return side == Side::inner ? raceway_radius + rise : raceway_radius - rise;
  }
};

template <class T> struct GroovePositionT {
  Vec3T<T> u, t;    // radial and circumferential unit vectors
  T r = T();        // m, distance from the ring axis to the ball centre
  T z = T();        // m, along the axis
  T s = T();        // m, distance from the circle of groove centres
  T nu = T();       // normal, radial component
  T ne = T();       // normal, axial component
};
using GroovePosition = GroovePositionT<double>;

// Sets the contact frame of a ball from r, z, the radial vector and s.
template <class T>
RACEWAY_INLINE void set_frame(const Vec3T<T> &radial, const Vec3T<T> &e, double centre_circle,
                              const T &s2, GroovePositionT<T> &p)
{
  p.u = radial * (1.0 / p.r);
  p.t = cross(e, p.u);
  p.s = square_root(s2);
  const T inverse = 1.0 / p.s;
  p.nu = (p.r - centre_circle) * inverse;
  p.ne = p.z * inverse;
}

// Locates a ball centre at d from the ring centre; e is the unit axis of the ring. Returns false,
// with only r and z set, if the ball centre is no farther than `slack` from the circle of groove
// centres (no contact); with slack < 0 the position is always set. Returns true for NaN, which must
// not count as a gap.
inline bool locate_beyond(const Vec3 &d, const Vec3 &e, double centre_circle, double slack,
                          GroovePosition &p)
{
  p.z = dot(d, e);
  const Vec3 radial = d - e * p.z;
  p.r = norm(radial);
  const double g = p.r - centre_circle, s2 = g * g + p.z * p.z;
  if (s2 <= slack * slack) return false;
  set_frame(radial, e, centre_circle, s2, p);
  return true;
}

// Does the same without branching, and sets every position.
template <class T>
RACEWAY_INLINE void locate(const Vec3T<T> &d, const Vec3T<T> &e, double centre_circle,
                           GroovePositionT<T> &p)
{
  p.z = dot(d, e);
  const Vec3T<T> radial = d - e * p.z;
  p.r = norm(radial);
  const T g = p.r - centre_circle;
  const T s2 = g * g + p.z * p.z;
  set_frame(radial, e, centre_circle, s2, p);
}

inline GroovePosition locate(const Vec3 &d, const Vec3 &e, double centre_circle)
{
  GroovePosition p;
  locate(d, e, centre_circle, p);
  return p;
}

}    // namespace raceway
