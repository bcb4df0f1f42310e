// SPDX-License-Identifier: GPL-2.0-or-later
// Extent of a groove of finite depth around a ball, which determines the capacitance of the gap
// outside the contact (docs/fix_bearing_capacitance).
//
// The shoulder of a groove of depth t lies at the angle theta_b from the bottom, seen from the
// ball's centre:
//   cos theta = 1 - t/r_c,  tan theta_b = r_c sin theta/(R_b - t).
// Along y across the groove, the parabola that approximates the gap ends at
//   S = R_b [4 tan((theta_b -+ alpha)/4) +- 0.09 gamma],  +0.09 inner, -0.09 outer,
// on the two sides of a contact at the contact angle alpha; gamma = R_b cos(alpha)/r_pitch. Within
// the contact ellipse the groove already has the shape of that parabola, so the amount by which the
// arc within the ellipse exceeds it is subtracted: 4 R_b q_a - a from the first term and the
// fraction (q_a/q)^2 of the second, where q is the tangent in S, q_a = tan(a/(4 R_b)), and a is the
// semi-axis across the groove.
//
// If a ring has two grooves, they meet in the ring's mid-plane. Seen from a ball in that plane, the
// shoulder of a groove is at
//   tan theta_b = (r_c sin theta - G)/(R_b - t + (r_c - R_b)(1 - cos alpha_0)),
// where G is the distance of the groove's centres from the plane and alpha_0 is the contact angle
// of the ball. The groove's other end is at the angle 0, so S = 4 R_b tan(alpha/4) on that side.
// The term with 0.09 is omitted, because it applies to sides that are twice as long and begin at
// the bottom.
#pragma once

#include "groove.h"

namespace raceway {

// Default depth of a groove as a fraction of the ball diameter, used if shoulder data are missing.
constexpr double usual_groove_depth = 0.18;

// Returns the tangent of half an angle from its sine and cosine; 0 <= angle < pi.
template <class T> RACEWAY_INLINE T half_tangent(const T &sine, const T &cosine)
{
  return sine / (1.0 + cosine);
}
// Returns the tangent of half an angle from its tangent.
template <class T> RACEWAY_INLINE T half_tangent(const T &tangent)
{
  return tangent / (1.0 + square_root(T(1.0 + tangent * tangent)));
}

template <class T> struct GrooveSideT {
  T reach;        // m
  T cotangent;    // cotangent of a quarter of the angle from the contact to the shoulder
};
template <class T> struct GrooveReachT {
  GrooveSideT<T> near, far;    // the side towards which the contact leans, and the other side
};

class GrooveShoulder {
 public:
  GrooveShoulder() = default;
  // `depth` is the depth of the groove at the shoulder (m); precondition: 0 < depth < ball radius
  GrooveShoulder(const Groove &g, double depth, double pitch_radius) :
      radius_(g.ball_radius),
      curved_((g.side == Side::inner ? 0.09 : -0.09) * g.ball_radius / pitch_radius),
      ends_in_the_middle_(g.offset != 0.0)
  {
    const double cosine = 1.0 - depth / g.groove_radius;
    double across = g.groove_radius * std::sqrt(1.0 - cosine * cosine),
           down = g.ball_radius - depth;
    if (ends_in_the_middle_) {
      curved_ = 0.0;
      across -= std::fabs(g.offset);
      down += g.slack() * (1.0 - g.middle_cosine());
    }
    quarter_ = half_tangent(across / (down + std::hypot(across, down)));
  }

  // Returns the reach for the sine and cosine (both 0 or more) of the contact angle; the reach is
  // negative towards a shoulder that the contact has passed. If a ring has two grooves, the far
  // side ends at the other groove.
  template <class T> RACEWAY_INLINE GrooveReachT<T> reach(const T &sine, const T &cosine) const
  {
    const T lean = half_tangent(half_tangent(sine, cosine)), both = quarter_ * lean,
            curved = curved_ * cosine;
    const T near = (quarter_ - lean) / (1.0 + both);
    const T far = ends_in_the_middle_ ? lean : T((quarter_ + lean) / (1.0 - both));
    return {{radius_ * (4.0 * near + curved), 1.0 / near},
            {radius_ * (4.0 * far + curved), 1.0 / far}};
  }

  // Returns the reach around an ellipse whose semi-axis across the groove is a (m).
  template <class T>
  RACEWAY_INLINE T around(const GrooveSideT<T> &side, const T &cosine, const T &a) const
  {
    const T curved = curved_ * cosine, u = a * (0.25 / radius_), u2 = u * u;
    // the tangent q_a, whose relative error is 3e-7 for an ellipse one radius wide
    const T within = u * (1.0 + u2 * (1.0 / 3 + u2 * (2.0 / 15 + u2 * (17.0 / 315))));
    const T ratio = within * side.cotangent;
    const T part = where((side.cotangent > 0.0) & (ratio < 1.0), ratio, 1.0);
    return side.reach + a - radius_ * (4.0 * within + curved * part * part);
  }

 private:
  double radius_ = 0.0, curved_ = 0.0;
  bool ends_in_the_middle_ = false;
  double quarter_ = 0.0;    // tan(theta_b/4)
};

}    // namespace raceway
