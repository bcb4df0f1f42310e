// SPDX-License-Identifier: GPL-2.0-or-later
// The one place that judges whether the formulas of a contact hold there.
//
// Refused: a contact ellipse as wide as the groove is, or an overlap beyond the limit of the deck.
// Warned of: a pressure that leaves dents, a film thicker than the contact is long, a film
// parameter beyond any bearing.
#ifndef RACEWAY_VALIDITY_H
#define RACEWAY_VALIDITY_H

#include "raceway_law.h"

#include <array>
#include <cmath>

namespace raceway {

// Overlap (m) from which on the semi-axis across the groove, a sqrt(overlap), is no smaller than
// the groove radius: Hertz's half-spaces are none any more. The rule of `raceway static`.
inline double widest_overlap(double a, double groove_radius)
{
  const double ratio = groove_radius / a;
  return ratio * ratio;
}

struct Validity {
  enum Doubt { PRESSURE, THICK_FILM, LAMBDA, N };

  struct Rule {
    const char *value, *unit, *limit;    // what is too large, and of what it is the limit
    double most;
  };
  // ISO 76: the largest pressure at the basic static load rating of ball bearings, with a dent of
  // 1e-4 of the ball diameter. Films of bearings have Lambda below 10.
  static const Rule &rule(int doubt)
  {
    static const Rule rules[N] = {{"Hertz pressure", " Pa", "ISO 76 allows ball bearings", 4.2e9},
                                  {"film thickness over the semi-axis b of its contact", "",
                                   "an elastohydrodynamic film is much thinner, at most", 1.0},
                                  {"film parameter Lambda", "", "films of bearings reach", 1e3}};
    return rules[doubt];
  }

  std::array<double, N> worst = {};    // so far
  std::array<double, N> ball = {};     // whose contact it was, an atom ID

  void note(double ball_id, const RacewayConstants &k, double overlap, double load,
            double entrainment, double lambda, bool film)
  {
    const double root = std::sqrt(overlap);
    keep(PRESSURE, k.p * root, ball_id);
    if (!film || !(load > 0.0) || !(entrainment > 0.0)) return;
    const double h_c = film_thickness(k.film.central, film_point(entrainment, load));
    keep(THICK_FILM, h_c / (k.b * root), ball_id);
    keep(LAMBDA, lambda, ball_id);
  }

 private:
  void keep(int doubt, double value, double ball_id)
  {
    if (!(value > worst[doubt])) return;
    worst[doubt] = value;
    ball[doubt] = ball_id;
  }
};

}    // namespace raceway

#endif
