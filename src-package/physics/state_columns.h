// SPDX-License-Identifier: GPL-2.0-or-later
// Columns that the state of a contact alone gives, a line each.
#ifndef RACEWAY_STATE_COLUMNS_H
#define RACEWAY_STATE_COLUMNS_H

#include "column.h"
#include "contact.h"

namespace raceway {

// Power lost in a contact, W: what its springs store on the way counts as lost until they give it
// back.
inline double friction_power(const ContactState &s)
{
  return s.friction_t * s.sliding_t + s.friction_w * s.sliding_w;
}
inline double damping_power(const ContactState &s) { return (s.normal - s.load) * s.overlap_rate; }

struct StateColumn {
  Column is;
  double (*value)(const RacewayPhysics &, const ContactState &);
  Needs needs = Needs::nothing;
  bool usual = true;    // part of a record unless more is asked for
};

namespace state_columns {

using P = const RacewayPhysics &;
using S = const ContactState &;

// positive on both raceways where the inner ring is pushed along the axis
inline double contact_angle(P p, S s)
{
  return std::atan2(p.groove.side == Side::inner ? -s.ne : s.ne, std::fabs(s.nu));
}
inline RacewayConstantsT<double> law(P p, S s) { return p.law.at(s.cos_angle); }

inline const StateColumn list[] = {
    {{"angle", "rad",
      "contact angle, positive where the inner ring is pushed along the positive axis"},
     contact_angle},
    {{"overlap", "m", "elastic approach"}, [](P, S s) { return s.overlap; }},
    {{"load", "N", "elastic contact load", vanishes}, [](P, S s) { return s.load; }},
    {{"normal", "N", "normal force with damping", vanishes}, [](P, S s) { return s.normal; }},
    {{"stiffness", "N/m", "slope of load over overlap", vanishes},
     [](P, S s) { return s.stiffness; },
     Needs::nothing,
     false},
    {{"damping", "N s/m", "normal damping, of the material and the film", vanishes},
     [](P, S s) { return s.damping; }},
    {{"a", "m", "semi-axis of the contact ellipse across the groove", vanishes},
     [](P p, S s) { return law(p, s).a * s.root; }},
    {{"b", "m", "semi-axis of the contact ellipse along rolling", vanishes},
     [](P p, S s) { return law(p, s).b * s.root; }},
    {{"pressure", "Pa", "largest Hertz pressure", vanishes},
     [](P p, S s) { return law(p, s).p * s.root; }},
    {{"entrainment", "m/s", "entrainment speed along rolling"},
     [](P, S s) { return s.entrainment; }},
    {{"sliding", "m/s", "speed of the ball's surface against the ring's"},
     [](P, S s) { return std::hypot(s.sliding_t, s.sliding_w); }},
    {{"mu", "", "friction coefficient"}, [](P, S s) { return s.mu; }},
    {{"friction", "N", "tangential force", vanishes},
     [](P, S s) { return std::hypot(s.friction_t, s.friction_w); }},
    {{"friction_t", "N", "tangential force along rolling, on the ring", vanishes},
     [](P, S s) { return s.friction_t; },
     Needs::nothing,
     false},
    {{"friction_w", "N", "tangential force across rolling, on the ring", vanishes},
     [](P, S s) { return s.friction_w; },
     Needs::nothing,
     false},
    {{"friction_power", "W", "power lost to the tangential force", vanishes},
     [](P, S s) { return friction_power(s); }},
    {{"damping_power", "W", "power lost to normal damping", vanishes},
     [](P, S s) { return damping_power(s); }},
    {{"h_min", "m", "smallest film thickness"}, [](P, S s) { return s.h_min; }, Needs::film},
    {{"lambda", "", "film parameter"}, [](P, S s) { return s.lambda; }, Needs::film},
    {{"regime", "", "0 boundary, 1 mixed, 2 full film", has_none, as_whole},
     [](P p, S s) { return double(regime({0.0, 0.0, p.lambda_1, p.lambda_2}, s.lambda)); },
     Needs::film},
};

}    // namespace state_columns

}    // namespace raceway

#endif
