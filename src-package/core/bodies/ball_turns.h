// SPDX-License-Identifier: GPL-2.0-or-later
// Orientations of four balls, where a profile of theirs asks for them: from the own axes of each
// ball to the frame that turns with its azimuth (lane_frame.h). There the ball's spin less that of
// the frame is constant over a stage, as all components are, so the turn by it is exact.
#ifndef RACEWAY_BALL_TURNS_H
#define RACEWAY_BALL_TURNS_H

#include "../numbers/lane_frame.h"
#include "../raceway/profiled_contact.h"

namespace raceway {

struct BodyGroup;

struct BallTurns {
  int group;
  Quaternion from[lanes], base[lanes], now[lanes], end[lanes] = {};
  Vec3 turn[lanes];    // rad, base to now

  explicit BallTurns(int of) : group(of) {}
  void load(int lane, const LaneFrame &, const Quaternion &lab);
  Quaternion stored(int lane, const LaneFrame &) const;
  void start();                                          // of a step: base is from
  void move(const BodyGroup &, double h);                // now is h seconds after base
  void coast(const BodyGroup &, double h, bool on);      // from there, or from now
  void second_base(double beyond);                       // base: so many times as far as now
  void accept();                                         // from is now
  void rest() { std::copy(from, from + lanes, now); }    // now is from
  void keep() { std::copy(now, now + lanes, end); }      // while now is put elsewhere
  void put_back() { std::copy(end, end + lanes, now); }
  // At the share s of a step of h seconds that ends at end, with these velocities.
  void between(const BodyGroup &, const LaneFrame &end_frame, const Vec3L &v, const Vec3L &w,
               double h, double s);

  // rad/s, of a ball against its frame
  static Vec3 rate(const Vec3L &v, const Vec3L &w, const LaneFrame &f, int lane)
  {
    return {w.x[lane], w.y[lane], w.z[lane] - v.y[lane] / f.r[lane]};
  }
  // Directions that are known in the frame, in the own axes.
  static BallView view(const Quaternion &ball, const Vec3 &n, const Vec3 &t, const Vec3 &w)
  {
    const Quaternion back = ball.back();
    return {back(n), back(t), back(w)};
  }
};

}    // namespace raceway

#endif
