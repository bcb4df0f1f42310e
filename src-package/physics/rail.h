// SPDX-License-Identifier: GPL-2.0-or-later
// A cage ball on a torus rail (docs/theory, Rings): elastic, frictionless, critically damped.
//
// The rail is a torus: centre-circle radius, tube radius, axial offset of that circle along the ring
// axis. Contact when the ball centre is nearer to the centre circle than ball radius + tube radius.
// Hertz constants are those of the seat: the ball touches the tube from the axis side under the seat
// angle (0 = radially outside the ball), so that along the rail the surface is concave.
#ifndef RACEWAY_RAIL_H
#define RACEWAY_RAIL_H

#include "damped_hertz.h"
#include "hertz.h"
#include "vec3.h"

namespace raceway {

struct Rail {
  double circle = 0.0;    // m, radius of the centre circle
  double tube = 0.0;      // m, radius of the tube
  double offset = 0.0;    // m, along the axis
};

// Two rails outside the pitch circle, one on each side, touching a cage ball of radius R that is
// centred on the pitch circle (gap = 0). Squeezed between two balls a cage ball is pushed outwards
// (the chord of the balls lies inside the pitch circle): outside rails at +-45 degrees form a V in
// which that push seats it, and the V holds it axially. See docs/theory, "Cage".
inline Rail seat_rail(double pitch, double ball_radius, double tube, double gap, double sign)
{
  const double reach = (ball_radius + tube + gap) * 0.70710678118654752440;
  return {pitch + reach, tube, sign * reach};
}

// Stiffness of ball on rail, N/m^1.5. pitch: radius of the ball path.
inline double rail_stiffness(const Rail &rail, double ball_radius, double pitch, double Eprime)
{
  const double dr = rail.circle - pitch, dz = rail.offset;
  const double distance = std::sqrt(dr * dr + dz * dz);
  const double cos_seat = dr / distance;
  const double contact_radius = pitch + ball_radius * cos_seat;    // of the contact point about the axis
  const double along = 1.0 / ball_radius - cos_seat / contact_radius;
  const double across = 1.0 / ball_radius + 1.0 / rail.tube;
  return hertz_contact(1.0 / along, 1.0 / across, Eprime, Ellipse::exact).K;
}

struct RailTouch {
  Vec3 n;           // rail -> ball
  DampedHertz h;
};

// The law of fix bearing/cage for one ball and rail, with the normal an implicit step needs. Ball centre at d from the
// ring centre, moving at dv against the ring there. False: no contact.
inline bool touch_rail(const Rail &rail, double K, const Vec3 &d, const Vec3 &e, double radius, double mass,
                       const Vec3 &dv, RailTouch &t)
{
  const double z = dot(d, e);
  const Vec3 radial = d - e * z;
  const double r = norm(radial);
  const double dr = r - rail.circle, dz = z - rail.offset, s2 = dr * dr + dz * dz;
  const double reach = radius + rail.tube;
  if (!(s2 < reach * reach)) return false;
  const double s = std::sqrt(s2);
  t.n = radial * (dr / (s * r)) + e * (dz / s);
  t.h = damped_hertz(K, reach - s, -dot(dv, t.n), mass);
  return t.h.force > 0.0;
}

}    // namespace raceway

#endif
