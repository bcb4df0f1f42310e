// SPDX-License-Identifier: GPL-2.0-or-later
// Four bodies on orbits about an axis, each in the frame that rotates with it: radius r, azimuth,
// height, and velocities along the radial, circumferential and axial directions of that frame.
//
// In a step of length h, a body with constant velocity components drifts by r += h v_r, azimuth +=
// h v_c/r (with the new r), z += h v_z. The drift is exact on a circular path, whereas a straight
// line would leave the path by h^2 v^2/(2r). Components in a rotating frame change because the
// frame rotates. With w = v_c/r this acceleration is -w z x v for a vector v, i.e. +w v_c along the
// radius and -w v_r along the circle; the same applies to the spin.
#pragma once

#include "vec3.h"

namespace raceway {

using Vec3L = Vec3T<Lane>;

RACEWAY_INLINE Vec3 in_lane(const Vec3L &a, int i) { return {a.x[i], a.y[i], a.z[i]}; }

// Cosine and sine are computed by Taylor series to x^16, with an error that is below 1e-18 up to
// 0.6 rad, the limit for a stage, and 5e-15 at 1.2 rad, the limit for a whole step with two stages
// or drifts.
constexpr double largest_turn = 0.6;
RACEWAY_INLINE void small_turn(const Lane &x, Lane &cosine, Lane &sine)
{
  const Lane y = x * x;
  const Lane c = 1.0 - y * (1.0 / 132) * (1.0 - y * (1.0 / 182) * (1.0 - y * (1.0 / 240)));
  cosine =
      1.0 -
      y * 0.5 *
          (1.0 - y * (1.0 / 12) *
                     (1.0 - y * (1.0 / 30) * (1.0 - y * (1.0 / 56) * (1.0 - y * (1.0 / 90) * c))));
  const Lane s =
      1.0 -
      y * (1.0 / 110) * (1.0 - y * (1.0 / 156) * (1.0 - y * (1.0 / 210) * (1.0 - y * (1.0 / 272))));
  sine =
      x * (1.0 - y * (1.0 / 6) *
                     (1.0 - y * (1.0 / 20) * (1.0 - y * (1.0 / 42) * (1.0 - y * (1.0 / 72) * s))));
}

struct LaneFrame {
  Lane r = {}, z = {};    // m
  Lane c = {}, s = {};    // cosine and sine of the azimuth

  // Convert a vector between the lab frame (bearing axis along z) and (radial, circumferential,
  // axial) components.
  RACEWAY_INLINE Vec3L local(const Vec3L &v) const
  {
    return {v.x * c + v.y * s, v.y * c - v.x * s, v.z};
  }
  RACEWAY_INLINE Vec3L local(const Vec3 &v) const
  {
    return {v.x * c + v.y * s, v.y * c - v.x * s, all_lanes(v.z)};
  }
  RACEWAY_INLINE Vec3L lab(const Vec3L &v) const
  {
    return {v.x * c - v.y * s, v.x * s + v.y * c, v.z};
  }
  RACEWAY_INLINE Vec3L place() const { return {r * c, r * s, z}; }

  // Sets one body, in lane i.
  void set(int i, const Vec3 &x)
  {
    r[i] = std::sqrt(x.x * x.x + x.y * x.y);
    z[i] = x.z;
    c[i] = x.x / r[i];
    s[i] = x.y / r[i];
  }

  // Returns the frame after it has moved at the local velocity v for the time h. `turn` is set to
  // the rotation (rad), which is accurate up to largest_turn.
  RACEWAY_INLINE LaneFrame drifted(const Vec3L &v, double h, Lane &turn) const
  {
    LaneFrame f;
    f.r = r + h * v.x;
    f.z = z + h * v.z;
    turn = h * v.y / f.r;
    f.turn_from(*this, turn);
    return f;
  }

  // Sets the azimuth to that of `from` plus `turn` (rad).
  RACEWAY_INLINE void turn_from(const LaneFrame &from, const Lane &turn)
  {
    Lane ct, st;
    small_turn(turn, ct, st);
    c = from.c * ct - from.s * st;
    s = from.s * ct + from.c * st;
  }
};

// Returns the rate of change of the components of `vector` in a frame that rotates at `rate`
// (rad/s).
RACEWAY_INLINE Vec3L frame_acceleration(const Lane &rate, const Vec3L &vector)
{
  return {rate * vector.y, -rate * vector.x, Lane{}};
}

}    // namespace raceway
