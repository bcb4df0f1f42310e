// SPDX-License-Identifier: GPL-2.0-or-later
// Contact between a cage ball and a torus-shaped rail (docs/theory, Rings): elastic, frictionless,
// critically damped.
//
// The rail is a torus that is defined by the radius of its centre circle, its tube radius and the
// offset of the circle along the ring axis. A ball touches it if the ball's centre is closer to the
// centre circle than ball radius + tube radius. The Hertz constants are those at the seat, where
// the ball touches the tube at the seat angle (0 = radially outside the ball) from the side of the
// ring axis, so that the surface is concave along the rail.
#pragma once

#include "../laws/damped_hertz.h"
#include "../laws/hertz.h"
#include "../numbers/vec3.h"

namespace raceway {

struct Rail {
  double circle = 0.0;    // m, radius of the centre circle
  double tube = 0.0;      // m, radius of the tube
  double offset = 0.0;    // m, along the axis
};

// Returns one of two rails outside the pitch circle, one on each side, which touch a cage ball of
// radius R that is centred on the pitch circle (if gap = 0). A cage ball squeezed between two balls
// is pushed outwards, because the chord between the balls lies inside the pitch circle. Outer rails
// at +-45 degrees form a V that seats the cage ball and holds it axially. See docs/theory, "Cage".
inline Rail seat_rail(double pitch, double ball_radius, double tube, double gap, double sign)
{
  const double reach = (ball_radius + tube + gap) * 0.70710678118654752440;
  return {pitch + reach, tube, sign * reach};
}

// Returns the stiffness between ball and rail, N/m^1.5. pitch: radius of the ball path.
inline double rail_stiffness(const Rail &rail, double ball_radius, double pitch, double Eprime)
{
  const double dr = rail.circle - pitch, dz = rail.offset;
  const double distance = std::sqrt(dr * dr + dz * dz);
  const double cos_seat = dr / distance;
  const double contact_radius =
      pitch + ball_radius * cos_seat;    // radius of the contact point about the axis
  const double along = 1.0 / ball_radius - cos_seat / contact_radius;
  const double across = 1.0 / ball_radius + 1.0 / rail.tube;
  return hertz_contact(1.0 / across, 1.0 / along, Eprime, Ellipse::exact).K;
}

// Contact of one cage ball with one rail in the meridional plane of the ring, for a ball centre at
// radius r and height z (m) and velocities vr, ve (m/s) relative to the ring. The code has no
// branches, so that a loop over many balls vectorises. If there is no contact, the force is 0.
template <class T> struct RailContactT {
  T nr, ne;     // normal from rail to ball, radial and axial
  T overlap;    // m
  DampedHertzT<T> h;
};

template <class T>
RACEWAY_INLINE RailContactT<T> rail_contact(const Rail &rail, double K, const T &r, const T &z,
                                            const T &vr, const T &ve, const T &radius,
                                            const T &mass)
{
  RailContactT<T> c;
  const T dr = r - rail.circle, dz = z - rail.offset, s = square_root(T(dr * dr + dz * dz));
  const T inverse = 1.0 / s, overlap = radius + rail.tube - s;
  c.nr = dr * inverse;
  c.ne = dz * inverse;
  c.overlap = overlap;
  c.h = damped_hertz(K, T(where(overlap > 0.0, overlap, 0.0)), T(-(vr * c.nr + ve * c.ne)), mass);
  return c;
}

// Returns true if a cage ball may be within `margin` (m) of the rail, without computing the square
// root. Even with rounding errors, the result is true whenever rail_contact() detects an overlap.
template <class T>
RACEWAY_INLINE auto may_touch(const Rail &rail, const T &r, const T &z, const T &radius,
                              double margin)
{
  const T dr = r - rail.circle, dz = z - rail.offset;
  const T reach = (radius + (rail.tube + margin)) * (1.0 + 1.0e-12);
  return dr * dr + dz * dz < reach * reach;
}

}    // namespace raceway
