// SPDX-License-Identifier: GPL-2.0-or-later
// The only place where the validity of the formulas for a contact is checked.
//
// Errors: a contact ellipse that is as wide as the groove, or an overlap above the limit set in the
// deck. Warnings: a pressure that causes permanent dents, a film that is thicker than the contact
// is long, a lambda ratio above the values found in bearings, a capacitance computed for a film
// that conducts, a film outside the range of Hamrock and Dowson's fit, or a contact ellipse that
// extends beyond the shoulder of the groove.
#pragma once

#include "raceway_law.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raceway {

struct Validity {
  enum Doubt { PRESSURE, THICK_FILM, LAMBDA, CONDUCTS, FILM_FIT, SHOULDER, N };

  struct Rule {
    const char *name, *value, *unit, *limit;    // a `value` that exceeds `bound` is doubtful
    double bound;
    bool below;    // the bound is a minimum instead of a maximum
  };
  // ISO 76 gives the maximum pressure at the basic static load rating of ball bearings, which
  // leaves a dent of 1e-4 of the ball diameter. Films in bearings have Lambda below 10; below 1 the
  // asperities touch continuously, and the contact is not a capacitor. Hamrock and Dowson (J. Lubr.
  // Technol. 99, 1977, 264, abstract) varied the ellipticity from one to eight. Python and the
  // documentation also read these rules.
  static const Rule &rule(int doubt)
  {
    static const Rule rules[N] = {
        {"pressure", "Hertz pressure", "Pa", "ISO 76 allows ball bearings", 4.2e9, false},
        {"thick_film", "film thickness over the semi-axis b of its contact", "",
         "an elastohydrodynamic film is much thinner, at most", 1.0, false},
        {"lambda", "lambda ratio", "", "films in bearings reach at most", 1e3, false},
        {"conducts", "lambda ratio beside a capacitance", "",
         "asperities conduct and a capacitance means little below", 1.0, true},
        {"film_fit", "ellipticity of a contact with Hamrock and Dowson's film", "",
         "their fit is valid up to", 8.0, false},
        {"shoulder", "reach of a contact ellipse over the reach of its groove", "",
         "the groove ends at its shoulder, at a ratio of", 1.0, false}};
    return rules[doubt];
  }
  static bool worse(int doubt, double value, double than)
  {
    return rule(doubt).below ? value < than : value > than;
  }

  std::array<double, N> worst;        // most extreme values so far
  std::array<double, N> ball = {};    // atom ID of the ball in that contact

  Validity()
  {
    for (int k = 0; k < N; ++k) worst[k] = rule(k).below ? HUGE_VAL : 0.0;
  }

  void note(double ball_id, const RacewayConstants &k, FilmModel law, double compression,
            double load, double entrainment, double lambda, bool film)
  {
    const double root = std::sqrt(compression);
    keep(PRESSURE, k.p * root, ball_id);
    if (!film || !(load > 0.0) || !(entrainment > 0.0)) return;
    const double h_c = film_thickness(k.film.central, film_point(entrainment, load));
    keep(THICK_FILM, h_c / (k.b * root), ball_id);
    keep(LAMBDA, lambda, ball_id);
    keep(CONDUCTS, lambda, ball_id);
    if (law == FilmModel::hamrock_dowson) keep(FILM_FIT, k.a / k.b, ball_id);
  }

  // A groove of this depth (m) ends at the angle theta from its bottom, cos theta = 1 - depth/r_c.
  // An ellipse whose semi-axis across the groove is a (m) extends up to the contact angle plus
  // asin(a/r_c).
  void note_reach(double ball_id, const Groove &g, double depth, double cos_angle, double a)
  {
    const double reach =
        std::acos(std::min(cos_angle, 1.0)) + std::asin(std::min(a / g.groove_radius, 1.0));
    keep(SHOULDER, reach / std::acos(1.0 - depth / g.groove_radius), ball_id);
  }

 private:
  void keep(int doubt, double value, double ball_id)
  {
    if (!worse(doubt, value, worst[doubt])) return;
    worst[doubt] = value;
    ball[doubt] = ball_id;
  }
};

}    // namespace raceway
