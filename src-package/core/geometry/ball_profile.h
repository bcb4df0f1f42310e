// SPDX-License-Identifier: GPL-2.0-or-later
// Deviation of a ball from a sphere, in its body-fixed axes: pits, waviness and tables. A direction
// from the ball's centre has an azimuth about the third axis and a latitude measured from the
// equator.
//
// The depth at a contact is the depth in the direction of the contact normal, as for a raceway at
// the ball's azimuth (raceway_profile.h). The path over a pit depends on the effective radius along
// rolling, as on a raceway. A wave is a spherical harmonic,
//   depth = A cos(n azimuth + phase) cos^n(latitude),
// which is smooth everywhere and equal to A cos(n azimuth + phase) on the equator. A table gives
// the depth along the equator, which fades as cos^2(latitude), so the slope is zero at the poles.
// The path of the ball over a table follows the same rule as on a raceway.
//
// A pit narrower than the contact patch covers a strip of the patch from y1 to y2, measured from
// the middle of the patch. The fraction of the load on the strip is half the difference between the
// fractions for two central pits of half-widths |y2| and |y1|, or half their sum if y1 and y2 lie
// on opposite sides.
#pragma once

#include "../laws/pit_load.h"
#include "../numbers/quaternion.h"
#include "raceway_profile.h"

namespace raceway {

struct BallPitShape : NotchShape {
  double latitude = 0.0;    // latitude of the pit's centre, rad
};

struct BallShape {
  std::vector<BallPitShape> pits;
  std::vector<Wave> waves;
  std::vector<PeriodicCurve> tables;    // depth along the equator, m
};

// Derivatives of the depth with respect to the direction, along and across the rolling direction
// (groove.h).
template <class T> struct alignas(sizeof(T)) BallSlopesT {
  T along = T(), across = T();              // m/rad, derivatives of the depth
  T path_along = T(), path_across = T();    // derivatives of the azimuth in the ball's axes
  T bend = T();                             // m, second derivative of the depth of waves and tables
                                            // with respect to azimuth
  T cross = T(), side = T();    // stiffness that couples approach and azimuth, N; stiffness in
                                // azimuth, N m
};
using BallSlopes = BallSlopesT<double>;

// Contact normal and directions along and across the rolling direction (groove.h), in the ball's
// body-fixed axes.
struct BallView {
  Vec3 n, t, w;
};

// The profile of one kind of ball on one kind of raceway.
class BallProfile {
 public:
  // The arguments are the radius of the ball and the effective radius along rolling, in m; the
  // semi-axis of the contact patch across the groove divided by sqrt(overlap), in sqrt(m); and the
  // stiffness of the contact, in N/m^1.5.
  BallProfile(const BallShape &shape, double radius, double rolling, double ellipse,
              double stiffness) :
      radius_(radius), ellipse_(ellipse), stiffness_(stiffness), waves_(shape.waves)
  {
    for (const BallPitShape &s : shape.pits)
      pits_.push_back({NotchPath(s, radius_ * std::cos(s.latitude), rolling), s.latitude, s.width});
    for (const PeriodicCurve &t : shape.tables) {
      tables_.push_back(rolled(t, radius_, rolling));
      spacings_.push_back(t.spacing());
    }
  }

  // Returns the overlap (m) after subtracting the depth of waves and tables. They are subtracted
  // before a raceway's profile is, whereas pits are subtracted after it.
  double all_round(double overlap, const BallView &view, BallSlopes &b) const
  {
    const Place at(view);
    b = BallSlopes();
    b.path_along = at.path_along;
    b.path_across = at.path_across;
    for (const Wave &wave : waves_) {
      const double angle = wave.order * at.azimuth + wave.phase, order = wave.order,
                   fade = std::pow(at.cosine, order - 1.0) * wave.amplitude;
      const double depth = fade * at.cosine * std::cos(angle),
                   round = -order * fade * at.cosine * std::sin(angle),
                   up = -order * fade * at.sine * std::cos(angle);
      overlap -= depth;
      b.along += round * at.path_along + up * at.up_along;
      b.across += round * at.path_across + up * at.up_across;
      b.bend -= order * order * depth;
    }
    for (const PeriodicCurve &table : tables_) {
      const CurveAt at_equator = table.at(at.azimuth);
      const double fade = at.cosine * at.cosine, round = at_equator.slope * fade,
                   up = -2.0 * at.cosine * at.sine * at_equator.value;
      overlap -= at_equator.value * fade;
      b.along += round * at.path_along + up * at.up_along;
      b.across += round * at.path_across + up * at.up_across;
      b.bend += at_equator.bend * fade;
    }
    return overlap;
  }

  // Returns the overlap (m) after subtracting the effect of pits. `energy` (J) and `follows` are
  // defined in ProfiledContact.
  double pits(double d, const BallView &view, BallSlopes &b, double &energy, double &follows) const
  {
    if (pits_.empty()) return d;
    const Place at(view);
    for (const Pit &pit : pits_) {
      const double from_middle = pit.path.from_middle(at.azimuth);
      if (!(std::fabs(from_middle) < pit.path.half_angle())) continue;
      const double y = radius_ * (pit.latitude - at.latitude), half = 0.5 * pit.width;
      const CurveAt deep = pit.path.at(from_middle);
      if (deep.value > 0.0) d = strip(d, deep, y - half, y + half, at, b, energy, follows);
    }
    return d;
  }

  // Returns the longest permitted step (s) if the normal n moves over the ball at the rate `moves`
  // (1/s).
  double longest_step(const Vec3 &n, const Vec3 &moves) const
  {
    const double round = n.x * n.x + n.y * n.y, speed = norm(moves);
    if (speed == 0.0) return HUGE_VAL;
    const double azimuth = std::atan2(n.y, n.x), most = 0.4 / speed;
    const double rate = (n.x * moves.y - n.y * moves.x) / std::fmax(round, 1e-6);
    double angle = HUGE_VAL;
    for (const Pit &p : pits_) angle = std::fmin(angle, p.path.longest_turn(azimuth, rate));
    for (const Wave &w : waves_) angle = std::fmin(angle, M_PI / (8.0 * w.order));
    for (double spacing : spacings_) angle = std::fmin(angle, spacing);
    return rate == 0.0 ? most : std::fmin(most, angle / std::fabs(rate));
  }

 private:
  struct Pit {
    NotchPath path;
    double latitude, width;    // rad, m
  };

  // A direction in the ball's axes, and the changes in azimuth and latitude per unit along t and w.
  struct Place {
    double sine, cosine, azimuth, latitude;
    double path_along, path_across, up_along, up_across;
    explicit Place(const BallView &view)
    {
      const Vec3 &n = view.n;
      cosine = std::fmax(1e-6, std::sqrt(n.x * n.x + n.y * n.y));
      sine = n.z;
      azimuth = std::atan2(n.y, n.x);
      latitude = std::atan2(sine, cosine);
      const Vec3 round = {-n.y / cosine, n.x / cosine, 0.0}, up = cross(n, round);
      path_along = dot(round, view.t) / cosine;
      path_across = dot(round, view.w) / cosine;
      up_along = dot(up, view.t);
      up_across = dot(up, view.w);
    }
  };

  double strip(double d, const CurveAt &deep, double y1, double y2, const Place &at, BallSlopes &b,
               double &energy, double &follows) const
  {
    const double to_e = 1.0 / (ellipse_ * ellipse_);
    const bool middle = y1 < 0.0 && y2 > 0.0;
    const double least = std::fmin(y1 * y1, y2 * y2) * to_e;
    if (!(d > 0.0)) return middle ? d - std::fmin(deep.value, least) : d;
    if (!middle && least >= d) return d;    // outside the contact patch
    const double D = deep.value;
    const PitLoad one = pit_load(d, D, y1 * y1 * to_e), two = pit_load(d, D, y2 * y2 * to_e);
    const double a = y1 < 0.0 ? 0.5 : -0.5, c = y2 > 0.0 ? 0.5 : -0.5, whole = 1.0 - a - c;
    const double root = std::sqrt(d), load = a * one.load + c * two.load + whole * d * root;
    if (!(load > 0.0)) {
      if (D < least) {
        b.along += deep.slope * at.path_along;
        b.across += deep.slope * at.path_across;
      }
      return d - std::fmin(D, least);
    }
    const double side = a * one.side + c * two.side, share = side / load,
                 dd = a * one.dd + c * two.dd + 1.5 * whole * root, dD = a * one.dD + c * two.dD,
                 DD = a * one.DD + c * two.DD,
                 over = 0.5 * (one.wide - two.wide) * radius_ / (ellipse_ * load);
    const double left = std::pow(load, 2.0 / 3.0);
    b.along += share * deep.slope * at.path_along + over * at.up_along;
    b.across += share * deep.slope * at.path_across + over * at.up_across;
    energy += stiffness_ *
              (a * one.energy + c * two.energy + 0.4 * whole * d * d * root - 0.4 * left * load);
    follows += dd / (1.5 * std::sqrt(left)) - 1.0;
    b.cross += stiffness_ * (dd * share + dD) * deep.slope;
    b.side += stiffness_ *
              (((dd * share + 2.0 * dD) * share + DD) * deep.slope * deep.slope - side * deep.bend);
    return left;
  }

  double radius_, ellipse_, stiffness_;    // m, sqrt(m), N/m^1.5
  std::vector<Wave> waves_;
  std::vector<PeriodicCurve> tables_;    // paths over the tables
  std::vector<double> spacings_;         // angular spacing of the points of each given table, rad
  std::vector<Pit> pits_;
};

}    // namespace raceway
