// SPDX-License-Identifier: GPL-2.0-or-later
// Walls that rotate with a shaft, in coordinates centred on its axis: the inner surface of a closed
// drum, or radial blades.
#pragma once

#include "../numbers/vec3.h"

#include <algorithm>
#include <cmath>

namespace raceway {

// Contact of a sphere with a wall: the overlap (m, negative if there is a gap) and the unit normal
// from the wall to the sphere.
struct WallTouch {
  double overlap = -HUGE_VAL;
  Vec3 n;
};

struct TurningWall {
  bool drum = true;
  int blades = 0;               // number of radial blades, the first of which is at the shaft's
                                // angle
  double r1 = 0.0, r2 = 0.0;    // radii of the blades' edges, m; r2 is also the drum's radius
  double z1 = 0.0, z2 = 0.0;    // positions of both ends along the axis, m
  int parts() const { return drum ? 3 : blades; }

  // Returns false only if a sphere of radius R at p cannot touch any part of the wall.
  bool near(const Vec3 &p, double R) const
  {
    const double r2_at = p.x * p.x + p.y * p.y, outer = r2 - R, inner = r1 - R;
    if (drum) return !(r2_at < outer * outer && p.z > z1 + R && p.z < z2 - R);
    return !(inner > 0.0 && r2_at < inner * inner);
  }

  // Evaluates the contact between a part of the wall and a sphere of radius R at p. The shaft is
  // along the third coordinate axis; `angle` (rad) is the rotation of the wall about it. The parts
  // of a drum are the shell, the first end and the second end.
  WallTouch touch(int part, const Vec3 &p, double R, double angle) const
  {
    if (drum) {
      if (part == 1) return {z1 + R - p.z, {0.0, 0.0, 1.0}};
      if (part == 2) return {p.z + R - z2, {0.0, 0.0, -1.0}};
      const double r = std::hypot(p.x, p.y);
      if (!(r > 0.0)) return {};
      return {r + R - r2, {-p.x / r, -p.y / r, 0.0}};
    }
    const double a = angle + 2.0 * M_PI * part / blades;
    const Vec3 out = {std::cos(a), std::sin(a), 0.0}, side = {-out.y, out.x, 0.0};
    const double u = dot(p, out), t = dot(p, side);
    const Vec3 d = out * (u - std::clamp(u, r1, r2)) + side * t +
                   Vec3{0.0, 0.0, p.z - std::clamp(p.z, z1, z2)};
    const double far = norm(d);
    if (!(far > 0.0)) return {};
    return {R - far, d * (1.0 / far)};
  }
  // Returns true if the centre p of a sphere lies outside the drum.
  bool lost(const Vec3 &p) const
  {
    return drum && (p.x * p.x + p.y * p.y > r2 * r2 || p.z < z1 || p.z > z2);
  }
};

}    // namespace raceway
