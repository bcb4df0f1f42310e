// SPDX-License-Identifier: GPL-2.0-or-later
// Settling of a bearing, i.e. the change in its mean values from the first to the second half of
// the most recent samples. If each half covers a whole ball pass, ball-pass ripple does not affect
// the change. This file does not depend on the host.
#pragma once

#include "../numbers/vec3.h"

#include <algorithm>
#include <cmath>

namespace bearing {

// One sample. The struct contains only doubles, so that it can be sent and written to restart
// files.
struct SettlingSample {
  double torque = 0.0;          // N m, friction torque; at steady speed, the friction power (W) may
                                // be used instead
  double load[2] = {};          // N, largest loads on the inner and the outer raceway
  double cage_speed = 0.0;      // rad/s
  double pocket_force = 0.0;    // N, largest force of a ball on its pocket in a one-piece cage
  double cage_orbit = 0.0;      // distance of a one-piece cage from the bearing's axis, as a
                                // fraction of half the play of its pockets
  // sums over the balls of the load, and of the load times the unit vector of the spin axis in the
  // radial, tangential and axial directions at the ball
  double weight = 0.0, axis[3] = {};

  // Adds the spin axis of a ball, given the load of the ball on the raceways (N), its position
  // relative to the bearing's centre (m), its spin (rad/s) and the unit vector of the bearing's
  // axis. A ball that does not spin has no spin axis.
  void ball(double load, const raceway::Vec3 &place, const raceway::Vec3 &spin,
            const raceway::Vec3 &bearing_axis)
  {
    using raceway::Vec3;
    const Vec3 radial = place - bearing_axis * dot(place, bearing_axis);
    const double radius = std::sqrt(dot(radial, radial)), speed = std::sqrt(dot(spin, spin));
    if (!(radius > 0.0) || !(speed > 0.0)) return;
    const Vec3 u = radial * (1.0 / radius);
    const double share = load / speed;
    weight += load;
    axis[0] += share * dot(spin, u);
    axis[1] += share * dot(spin, cross(bearing_axis, u));
    axis[2] += share * dot(spin, bearing_axis);
  }

  // Adds s times the values of another sample.
  void add(const SettlingSample &of, double s = 1.0)
  {
    torque += s * of.torque;
    for (int k = 0; k < 2; ++k) load[k] += s * of.load[k];
    cage_speed += s * of.cage_speed;
    pocket_force += s * of.pocket_force;
    cage_orbit += s * of.cage_orbit;
    weight += s * of.weight;
    for (int k = 0; k < 3; ++k) axis[k] += s * of.axis[k];
  }
  SettlingSample times(double s) const
  {
    SettlingSample scaled;
    scaled.add(*this, s);
    return scaled;
  }
};

// Relative changes. The change in load is the larger of the changes on the two raceways. The change
// in spin axis is an angle (rad). Pocket forces are impacts, which scatter, so only a decrease
// counts; if they increase, the change is 0. The change in the orbit of a cage is not relative,
// because the orbit may be 0.
struct SettlingChanges {
  double torque = HUGE_VAL, load = HUGE_VAL, cage_speed = HUGE_VAL, spin_axis = HUGE_VAL,
         pocket_fall = HUGE_VAL, cage_orbit = HUGE_VAL;

  bool within(const SettlingChanges &limits) const    // false for NaN
  {
    return torque <= limits.torque && load <= limits.load && cage_speed <= limits.cage_speed &&
           spin_axis <= limits.spin_axis && pocket_fall <= limits.pocket_fall &&
           cage_orbit <= limits.cage_orbit;
  }
};

// Settling of a bearing, computed from its samples. Like SettlingSample, the class contains only
// doubles.
class Settling {
 public:
  explicit Settling(int samples_of_a_half = 1) : wanted_(samples_of_a_half) {}

  void add(const SettlingSample &s)
  {
    if (now_.count >= wanted_) {
      before_ = now_;
      now_ = Half();
    }
    now_.count += 1.0;
    now_.sum.add(s);
  }

  // Returns true at the end of every half except the first.
  bool known() const { return before_.count >= wanted_ && now_.count >= wanted_; }

  // Returns the changes from the last half but one to the last half. They are infinite unless
  // known() is true.
  SettlingChanges changes() const
  {
    if (!known()) return {};
    const SettlingSample &before = before_.sum, &now = now_.sum;
    double turned = 0.0;
    for (int k = 0; k < 3; ++k) {
      const double a = share(before.axis[k], before.weight), b = share(now.axis[k], now.weight);
      turned += (b - a) * (b - a);
    }
    return {change(before.torque, now.torque),
            std::max(change(before.load[0], now.load[0]), change(before.load[1], now.load[1])),
            change(before.cage_speed, now.cage_speed),
            std::sqrt(turned),
            share(std::max(before.pocket_force - now.pocket_force, 0.0), before.pocket_force),
            std::fabs(now.cage_orbit - before.cage_orbit) / wanted_};
  }

 private:
  struct Half {
    double count = 0.0;
    SettlingSample sum;
  };
  static double change(double before, double now)
  {
    return now == before ? 0.0 : std::fabs(now - before) / std::fabs(now);
  }
  static double share(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

  double wanted_;
  Half before_, now_;
};

}    // namespace bearing
