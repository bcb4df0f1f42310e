// SPDX-License-Identifier: GPL-2.0-or-later
// Rotation of a ball that rolls on both raceways with the smallest total loss due to spin
// (docs/tribology, Start of the balls).
//
// In the plane spanned by the bearing's axis (e) and the ball's radial direction (u), contact k has
// the normal n_k from ball to raceway. If the ball rolls on both raceways, one speed x remains
// free, and the orbital speed, the rotation and both spins omega_k are linear in x. The spin
// moments M_k(omega_k) increase with spin up to a certain width and are constant beyond it. They
// are in equilibrium where the sum of M_k d omega_k/dx vanishes. If the width is zero, this is the
// motion with the smallest loss, in which one raceway controls the ball; otherwise the spin is
// shared by both raceways. The sum increases with x, so the root is unique. It lies between the
// motion without spin at one raceway and the motion without spin at the other.
#pragma once

#include <algorithm>
#include <cmath>

namespace raceway {

// One of the two contacts of the ball. Its angle is positive on the +e side at the outer raceway
// and on the -e side at the inner one.
struct SpinContact {
  double angle = 0.0;     // rad, below pi/2 in magnitude
  double speed = 0.0;     // rad/s, of the ring
  double couple = 1.0;    // couple of pure spin, in N m or in any unit as long as it is the same
                          // for both contacts
  double width = 0.0;     // rad/s, spin up to which the couple increases

  double moment(double spin) const
  {
    const double most = std::max(std::fabs(spin), width);
    return most > 0.0 ? couple * spin / most : 0.0;
  }
};

struct BallRotation {
  double orbit = 0.0;                  // rad/s, of the ball centres (and cage) about the bearing
                                       // axis
  double radial = 0.0, axial = 0.0;    // rad/s, inertial frame
  double spin[2] = {};                 // rad/s, of the ball relative to the ring, about the contact
                                       // normal

  BallRotation operator-(const BallRotation &o) const
  {
    return {orbit - o.orbit,
            radial - o.radial,
            axial - o.axial,
            {spin[0] - o.spin[0], spin[1] - o.spin[1]}};
  }
};

// Returns the motion that rolls on both raceways with the radial rotation `radial` (rad/s), for the
// ball radius R and the radius r of the circle of ball centres (m).
inline BallRotation rolling_on_both(const SpinContact &inner, const SpinContact &outer, double R,
                                    double r, double radial)
{
  const double ci = std::cos(inner.angle), si = std::sin(inner.angle);
  const double co = std::cos(outer.angle), so = std::sin(outer.angle);
  const double way_i = r / R - ci, way_o = r / R + co;    // contact radii divided by R
  BallRotation m;
  m.radial = radial;
  m.orbit = (inner.speed * way_i * co + outer.speed * way_o * ci + radial * (ci * so - si * co)) /
            (way_i * co + way_o * ci);
  const double to_inner = inner.speed - m.orbit, to_outer = outer.speed - m.orbit;
  const double axial = (to_outer * way_o + radial * so) / co;    // relative to the cage
  m.axial = m.orbit + axial;
  m.spin[0] = -radial * ci - (axial - to_inner) * si;
  m.spin[1] = radial * co + (axial - to_outer) * so;
  return m;
}

// Returns the motion with the smallest loss.
inline BallRotation start_attitude(const SpinContact &inner, const SpinContact &outer, double R,
                                   double r)
{
  const BallRotation none = rolling_on_both(inner, outer, R, r, 0.0),
                     turn = rolling_on_both(inner, outer, R, r, 1.0) - none;
  double ends[2];    // values of x for motion without spin at one of the raceways
  for (int k = 0; k < 2; ++k) ends[k] = -none.spin[k] / turn.spin[k];
  double low = std::min(ends[0], ends[1]), high = std::max(ends[0], ends[1]);
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    if (!(low < middle && middle < high)) break;
    const double slope = inner.moment(none.spin[0] + turn.spin[0] * middle) * turn.spin[0] +
                         outer.moment(none.spin[1] + turn.spin[1] * middle) * turn.spin[1];
    if (slope > 0.0) high = middle;
    else low = middle;
  }
  return rolling_on_both(inner, outer, R, r, 0.5 * (low + high));
}

}    // namespace raceway
