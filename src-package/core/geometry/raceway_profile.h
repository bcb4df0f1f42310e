// SPDX-License-Identifier: GPL-2.0-or-later
// Deviation of a raceway from a torus: notches and pits, waviness and measured tables. Depths are
// measured from the torus into the ring, and azimuths in the ring's own frame.
//
// A ball follows a flaw only as far as the ball's size allows (docs/theory, Flaws of a raceway).
// If the effective radius along rolling is R_x and the edges have the radius E, the path of the
// ball over a notch of length w is
//   depth = (w/2 - |s|)^2/(2 (R_x + E)),
// but at most the depth of the notch; s is measured along the raceway from the middle of the notch.
// The kink in the path, in the middle or at the bottom, is smoothed over +-E.
#pragma once

#include "../numbers/periodic_curve.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raceway {

struct NotchShape {
  double azimuth = 0.0;                             // rad, azimuth of the notch's centre
  double length = 0.0, width = 0.0, depth = 0.0;    // m; width HUGE_VAL: across the whole groove
  double edge = 0.0;                                // m, radius of the edges
};

struct Wave {
  int order = 1;
  double amplitude = 0.0, phase = 0.0;    // m, rad; depth = amplitude cos(order azimuth + phase)
};

struct ProfileShape {
  std::vector<NotchShape> notches;
  std::vector<Wave> waves;
  std::vector<PeriodicCurve> tables;    // depth, m
};

// The path of one kind of ball over a notch.
class NotchPath {
 public:
  NotchPath(const NotchShape &n, double raceway_radius, double rolling_radius) :
      shape_(n), raceway_(raceway_radius), curve_(rolling_radius + n.edge), half_(0.5 * n.length)
  {
    const double bottom = std::fmax(0.0, half_ - std::sqrt(2.0 * curve_ * n.depth));
    turned_ = std::fmax(0.0, bottom - n.edge);
    turns_ = bottom + n.edge;
    steepest_ = (half_ - turns_) / curve_;
    deepest_ = 0.5 * (half_ - turns_) * steepest_ + 0.5 * steepest_ * (turns_ - turned_);
  }

  const NotchShape &shape() const { return shape_; }
  double half_angle() const { return half_ / raceway_; }    // angle, rad
  // Returns true if the path has a slope before its bend.
  bool falls() const { return half_ > turns_; }

  // Returns the largest step (rad) from an azimuth in the direction of `rate`. It ends at the edge
  // of the notch or, inside the notch, is a fifth of the edge radius long.
  double longest_turn(double azimuth, double rate) const
  {
    const double fine = 0.2 * shape_.edge / raceway_;
    const double x = from_middle(azimuth) * (rate > 0.0 ? 1.0 : -1.0);
    if (std::fabs(x) < half_angle()) return fine;
    return std::fmax((x < 0.0 ? -x : 2.0 * M_PI - x) - half_angle(), fine);
  }

  // Returns the azimuth relative to the middle of the notch, rad, from -pi to pi.
  double from_middle(double azimuth) const
  {
    return std::remainder(azimuth - shape_.azimuth, 2.0 * M_PI);
  }

  // Returns the depth and its derivatives with respect to the azimuth.
  CurveAt at(double from_middle) const
  {
    const double s = raceway_ * from_middle, a = std::fabs(s);
    if (!(a < half_)) return {};
    if (a <= turned_) return {deepest_, 0.0, 0.0};
    const double side = s < 0.0 ? -raceway_ : raceway_, squared = raceway_ * raceway_;
    if (a >= turns_) {
      const double left = half_ - a;
      return {0.5 * left * left / curve_, -side * left / curve_, squared / curve_};
    }
    const double bend = -steepest_ / (turns_ - turned_), on = a - turned_;
    return {deepest_ + 0.5 * bend * on * on, side * bend * on, squared * bend};
  }

 private:
  NotchShape shape_;
  double raceway_, curve_, half_;                 // m
  double turned_, turns_, steepest_, deepest_;    // in m, m, 1 and m; the path is curved from
                                                  // turns_ inwards
};

// Returns the path of a ball over a surface given by a table, i.e. the part of the surface that the
// ball can touch.
inline PeriodicCurve rolled(const PeriodicCurve &surface, double raceway_radius,
                            double rolling_radius)
{
  const int n = std::max(16384, static_cast<int>(std::lround(8.0 * M_PI / surface.spacing())));
  const double step = 2.0 * M_PI / n, arc = raceway_radius * step;
  std::vector<double> depth(n), path(n);
  for (int k = 0; k < n; ++k) depth[k] = surface.at(k * step).value;
  const auto [least, most] = std::minmax_element(depth.begin(), depth.end());
  const int reach = std::min(
      n / 2, static_cast<int>(std::sqrt(2.0 * rolling_radius * (*most - *least)) / arc) + 1);
  for (int k = 0; k < n; ++k) {
    path[k] = depth[k];
    for (int i = -reach; i <= reach; ++i) {
      const double s = i * arc;
      path[k] = std::min(path[k], depth[(k + i + n) % n] + 0.5 * s * s / rolling_radius);
    }
  }
  return PeriodicCurve(0.0, path);
}

class RacewayProfile {
 public:
  // The arguments are the radius of the raceway and the effective radius along rolling, in m, and
  // the semi-axis of the contact patch across the groove divided by sqrt(overlap), in sqrt(m).
  RacewayProfile(const ProfileShape &shape, double radius, double rolling, double ellipse) :
      radius_(radius), ellipse_(ellipse), waves_(shape.waves)
  {
    for (const NotchShape &n : shape.notches) notches_.emplace_back(n, radius_, rolling);
    for (const PeriodicCurve &t : shape.tables) {
      tables_.push_back(rolled(t, radius_, rolling));
      spacings_.push_back(t.spacing());
    }
  }

  const std::vector<NotchPath> &notches() const { return notches_; }
  double ellipse() const { return ellipse_; }    // sqrt(m), semi-axis across the groove divided by
                                                 // sqrt(overlap)

  // Returns the total depth of the profiles that extend across the whole groove.
  CurveAt across(double azimuth) const
  {
    CurveAt sum;
    const auto add = [&sum](const CurveAt &c) {
      sum.value += c.value;
      sum.slope += c.slope;
      sum.bend += c.bend;
    };
    for (const NotchPath &n : notches_)
      if (n.shape().width == HUGE_VAL) add(n.at(n.from_middle(azimuth)));
    for (const Wave &w : waves_) {
      const double at = w.order * azimuth + w.phase, c = w.amplitude * std::cos(at);
      add({c, -w.order * w.amplitude * std::sin(at), -double(w.order) * w.order * c});
    }
    for (const PeriodicCurve &t : tables_) add(t.at(azimuth));
    return sum;
  }

  // Returns the pit under a ball, or null; pits do not overlap.
  const NotchPath *pit(double azimuth) const
  {
    for (const NotchPath &n : notches_)
      if (n.shape().width != HUGE_VAL && std::fabs(n.from_middle(azimuth)) < n.half_angle())
        return &n;
    return nullptr;
  }

  // Returns the longest step (s) for a ball at this azimuth that moves along the raceway at `rate`
  // (rad/s). It ends at the edge of a notch and is at most a fifth of the edge radius inside a
  // notch, a sixteenth of a wave, and the spacing between two points of a table.
  double longest_step(double azimuth, double rate) const
  {
    if (rate == 0.0) return HUGE_VAL;
    double angle = HUGE_VAL;
    for (const NotchPath &n : notches_) angle = std::fmin(angle, n.longest_turn(azimuth, rate));
    for (const Wave &w : waves_) angle = std::fmin(angle, M_PI / (8.0 * w.order));
    for (double spacing : spacings_) angle = std::fmin(angle, spacing);
    return angle / std::fabs(rate);
  }

 private:
  double radius_, ellipse_;
  std::vector<NotchPath> notches_;
  std::vector<Wave> waves_;
  std::vector<PeriodicCurve> tables_;
  std::vector<double> spacings_;    // angular spacing of the points of each given table, rad
};

}    // namespace raceway
