// SPDX-License-Identifier: GPL-2.0-or-later
// Kinematics of pure rolling at zero contact angle. A rotating bearing starts in this state.
#pragma once

namespace raceway {

struct Rolling {
  double orbit = 0.0;    // rad/s, speed of the ball centres (and cage) about the bearing axis
  double spin =
      0.0;    // rad/s, spin of the ball about its own axis, parallel to the bearing axis, in the
              // inertial frame
};

// Computes pure rolling from the ball radius R (m), the pitch radius r (m) and the ring speeds
// (rad/s). There is no slip at the radii r - R (inner raceway) and r + R (outer raceway).
inline Rolling pure_rolling(double R, double r, double inner_speed, double outer_speed)
{
  Rolling k;
  k.orbit = 0.5 * (inner_speed * (r - R) + outer_speed * (r + R)) / r;
  k.spin = (k.orbit * r - inner_speed * (r - R)) / R;
  return k;
}

}    // namespace raceway
