// SPDX-License-Identifier: GPL-2.0-or-later
// Orientations of four balls, which are tracked if at least one of them has a profile. An
// orientation is the rotation from the ball's body-fixed axes to the frame that rotates with its
// azimuth (lane_frame.h). Like all components in that frame, the spin of the ball relative to the
// frame is constant over a stage, so the rotation is exact.
#pragma once

#include "../numbers/lane_frame.h"
#include "../raceway/profiled_contact.h"

namespace raceway {

struct BodyGroup;

struct BallTurns {
  int group;
  Quaternion from[lanes], base[lanes], now[lanes], end[lanes] = {};
  Vec3 turn[lanes];    // rad, rotation from `base` to `now`

  explicit BallTurns(int of) : group(of) {}
  void load(int lane, const LaneFrame &, const Quaternion &lab);
  Quaternion stored(int lane, const LaneFrame &) const;
  void start();                                          // starts a step: base = from
  void move(const BodyGroup &, double h);                // now is h seconds after base
  void coast(const BodyGroup &, double h, bool on);      // starts at `from`, or at `now` if `on`
  void second_base(double beyond);                       // base = from, rotated by `beyond` times
                                                         // the last rotation
  void accept();                                         // from = now
  void rest() { std::copy(from, from + lanes, now); }    // now = from
  void keep() { std::copy(now, now + lanes, end); }      // saves `now` before it is changed
  void put_back() { std::copy(end, end + lanes, now); }
  // Sets the orientation at the fraction s of a step of h seconds that ends at `end` with the
  // velocities v and w.
  void between(const BodyGroup &, const LaneFrame &end_frame, const Vec3L &v, const Vec3L &w,
               double h, double s);

  // Returns the angular velocity of a ball relative to its frame, rad/s.
  static Vec3 rate(const Vec3L &v, const Vec3L &w, const LaneFrame &f, int lane)
  {
    return {w.x[lane], w.y[lane], w.z[lane] - v.y[lane] / f.r[lane]};
  }
  // Converts the directions n, t and w from the frame to the ball's body-fixed axes.
  static BallView view(const Quaternion &ball, const Vec3 &n, const Vec3 &t, const Vec3 &w)
  {
    const Quaternion back = ball.back();
    return {back(n), back(t), back(w)};
  }
};

}    // namespace raceway
