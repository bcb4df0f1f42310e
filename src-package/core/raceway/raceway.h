// SPDX-License-Identifier: GPL-2.0-or-later
// Data of a raceway that are used by all parts of the contact law: the groove, the materials, the
// lubricant, the surfaces, and the constants derived from them. Parameters of a single part are
// stored in that part (law.h).
#pragma once

#include "../laws/film_factors.h"
#include "../numbers/dual.h"
#include "raceway_law.h"

namespace raceway {

struct Raceway {
  int number = 0;    // index of the groove among the grooves of a ring for one ball, counted from 0
                     // along the axis
  Groove groove;
  RacewayMaterial material;
  RacewayModel model;
  double ring_roughness = 0.0;    // m
  double ball_roughness = 0.0;    // m
  FilmFactors factors;
  // lambda ratios at the end of the boundary regime and at the start of the full film
  double lambda_1 = 1.0, lambda_2 = 3.0;

  // computed by prepare()
  RacewayLaw law;
  double overlap_limit = 0.0;                                        // largest overlap allowed, as
                                                                     // a fraction of the ball's
                                                                     // radius
  double centre_circle = 0.0, slack = 0.0, largest_overlap = 0.0;    // m
  double roughness = 0.0, inverse_roughness = 0.0;                   // m, 1/m
  double ln_inverse_roughness = 0.0;    // ln of a value in 1/m; minus infinity if there is no
                                        // roughness
  double ball_mass = 0.0;               // kg
  double pitch_radius = 0.0;            // m
  double reach = 0.0;    // m, gap at which contacts begin (0 unless it is set by a part of the law)

  // Returns a description of what limits the overlap, for use in messages.
  const char *limit() const
  {
    return largest_overlap < overlap_limit * groove.ball_radius
               ? "the contact ellipse is as wide as the groove"
               : "overlap_limit of the ball radius";
  }

  // Return the effective radii along and across the rolling direction, m (groove_radii).
  template <class T> RACEWAY_INLINE T rolling_radius(const T &cos_angle) const
  {
    const double gamma = groove.ball_radius / pitch_radius;
    return groove.ball_radius * (1.0 + (groove.side == Side::inner ? -gamma : gamma) * cos_angle);
  }
  double transverse_radius() const
  {
    return groove.ball_radius * groove.groove_radius / (groove.groove_radius - groove.ball_radius);
  }

  // Applies the thermal strains of ring and ball, which displace the surfaces. The constants of the
  // law remain those of the cold parts, because their relative change is as small as the strain.
  void grow(double ring, double ball)
  {
    centre_circle = groove.centre_circle() * (1.0 + ring);
    slack = groove.groove_radius * (1.0 + ring) - groove.ball_radius * (1.0 + ball);
  }

  // `pitch` is the radius of the pitch circle (m), which determines gamma; `mass` is the mass of
  // the ball (kg); `limit` is the largest overlap allowed, as a fraction of the ball's radius.
  void prepare(double pitch, double mass, double limit)
  {
    overlap_limit = limit;
    law = RacewayLaw(groove, pitch, material, model);
    grow(0.0, 0.0);
    largest_overlap = std::fmin(overlap_limit * groove.ball_radius,
                                widest_overlap(law.radial().a, groove.groove_radius));
    roughness = composite_roughness(ring_roughness, ball_roughness);
    inverse_roughness = roughness > 0.0 ? 1.0 / roughness : 0.0;
    ln_inverse_roughness = std::log(inverse_roughness);
    ball_mass = mass;
    pitch_radius = pitch;
    factors.prepare(model.lubricant.viscosity);
  }
};

// Returns the product of all film factors at a load and a speed.
template <class T, class State>
RACEWAY_INLINE T film_factor(const Raceway &p, const RacewayConstantsT<T> &k, const State &c,
                             const FilmPointT<T> &at)
{
  if (!p.factors.by_pressure) return p.factors.of(at.ln_speed);
  const T along = held(c.sliding_t), across = held(c.sliding_w);
  const T root = exponential(T((at.ln_load - logarithm(k.K)) * (1.0 / 3.0)));
  return p.factors.gupta(at.ln_speed, T(along * along + across * across))
      .of(T(k.p * root / p.material.Eprime()));
}

}    // namespace raceway
