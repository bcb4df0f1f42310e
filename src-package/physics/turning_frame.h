// SPDX-License-Identifier: GPL-2.0-or-later
// A body that circles an axis, in the frame that turns with it: radius r, azimuth, height, and velocities along
// the radial, circumferential and axial direction of that frame.
//
// Over a step h the body drifts as r += h v_r, azimuth += h v_c/r0, z += h v_z and keeps its components: on a
// circular path the drift is exact, while a straight line leaves the path by h^2 v^2/(2r). Keeping components in
// a turning frame needs the frame's own acceleration: with w = v_c/r it is -w z x v for a vector v, that is
// +w v_c along the radius and -w v_r along the circle; the spin needs the same.
#ifndef RACEWAY_TURNING_FRAME_H
#define RACEWAY_TURNING_FRAME_H

#include "vec3.h"

namespace raceway {

struct TurningFrame {
  double r = 0.0, z = 0.0;    // m
  double c = 1.0, s = 0.0;    // cosine and sine of the azimuth

  // v in lab axes (axis along z) <-> (radial, circumferential, axial)
  Vec3 local(const Vec3 &v) const { return {v.x * c + v.y * s, v.y * c - v.x * s, v.z}; }
  Vec3 lab(const Vec3 &v) const { return {v.x * c - v.y * s, v.x * s + v.y * c, v.z}; }
  Vec3 place() const { return {r * c, r * s, z}; }

  static TurningFrame at(const Vec3 &x)
  {
    TurningFrame f;
    f.r = std::sqrt(x.x * x.x + x.y * x.y);
    f.z = x.z;
    f.c = x.x / f.r;
    f.s = x.y / f.r;
    return f;
  }

  // After the time h with local velocity v.
  TurningFrame drifted(const Vec3 &v, double h) const
  {
    const double turn = h * v.y / r, ct = std::cos(turn), st = std::sin(turn);
    TurningFrame f;
    f.r = r + h * v.x;
    f.z = z + h * v.z;
    f.c = c * ct - s * st;
    f.s = s * ct + c * st;
    return f;
  }
};

// Acceleration of the components of `vector` in a frame that turns at `rate` (rad/s).
inline Vec3 frame_acceleration(double rate, const Vec3 &vector) { return {rate * vector.y, -rate * vector.x, 0.0}; }

}    // namespace raceway

#endif
