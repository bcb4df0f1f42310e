// SPDX-License-Identifier: GPL-2.0-or-later
// All constants of one raceway that a contact needs, as functions of the contact angle.
//
// The effective radii follow the contact angle (docs/theory, Geometry), and with them stiffness,
// ellipse and film exponents. They depend on cos(alpha) only, so they are computed once on a
// uniform grid of cos(alpha) in [0, 1] and interpolated by a four-point cubic: relative error below
// 1e-9 (tested). A radial scene stays at cos(alpha) = 1 and uses those constants directly.
#ifndef RACEWAY_RACEWAY_LAW_H
#define RACEWAY_RACEWAY_LAW_H

#include "damping.h"
#include "film.h"
#include "groove.h"
#include "hertz.h"

#include <array>
#include <vector>

namespace raceway {

template <class T> struct RacewayConstantsT {
  T K;                  // N/m^1.5
  T a, b;               // sqrt(m), semi-axes over sqrt(overlap)
  T p;                  // Pa/sqrt(m)
  FilmPairT<T> film;    // h_min, h_c
  T film_damper;        // N s/m^0.5, C_fluid = film_damper * a sqrt(overlap) * h^-1.5
  T unit;               // m, compression under 1 N, K^(-2/3)
};
using RacewayConstants = RacewayConstantsT<double>;

struct RacewayMaterial {
  double ball_young = 210e9, ball_poisson = 0.3;
  double ring_young = 210e9, ring_poisson = 0.3;
  double Eprime() const
  {
    return reduced_modulus(ball_young, ball_poisson, ring_young, ring_poisson);
  }
};

struct RacewayModel {
  Ellipse ellipse = Ellipse::exact;
  FilmModel film = FilmModel::masjedi_khonsari;
  Lubricant lubricant;                   // viscosity 0: dry
  bool damper_full_axis = false;         // eq 5 with 2a instead of a
  bool damper_rolling_radius = false;    // eq 5 with R_x instead of R_b
};

// Exact constants at one contact angle.
inline RacewayConstants raceway_constants(const Groove &g, double pitch_radius,
                                          const RacewayMaterial &mat, const RacewayModel &model,
                                          double cos_angle)
{
  const double E = mat.Eprime();
  const EffectiveRadii R =
      groove_radii(g.ball_radius, g.groove_radius, pitch_radius, g.side == Side::inner, cos_angle);
  const HertzContact h = hertz_contact(R.x, R.y, E, model.ellipse);
  RacewayConstants c{h.K, h.a, h.b, h.p, FilmPair{}, 0.0, std::pow(h.K, -2.0 / 3.0)};
  if (model.lubricant.viscosity > 0.0) {
    c.film = film_laws(model.film, h.ellipse.kappa, model.lubricant, E, R.x);
    c.film_damper = film_damping_prefactor(model.lubricant.viscosity,
                                           model.damper_rolling_radius ? R.x : g.ball_radius,
                                           model.damper_full_axis ? 2.0 : 1.0);
  }
  return c;
}

class RacewayLaw {
 public:
  RacewayLaw() = default;
  RacewayLaw(const Groove &g, double pitch_radius, const RacewayMaterial &mat,
             const RacewayModel &model) :
      radial_(raceway_constants(g, pitch_radius, mat, model, 1.0)), packed_radial_(pack(radial_)),
      grid_(cells + 3)
  {
    // one node beyond each end so that every cell has its four points
    for (int i = 0; i < cells + 3; ++i)
      grid_[i] = pack(raceway_constants(g, pitch_radius, mat, model, double(i - 1) / cells));
  }

  const RacewayConstants &radial() const { return radial_; }

  // Constants at cos(alpha); below 1e-12 from 1 the radial ones are exact to rounding.
  RACEWAY_INLINE RacewayConstants at(double cos_angle) const
  {
    return 1.0 - cos_angle < 1e-12 ? radial_ : oblique(cos_angle);
  }

  RACEWAY_INLINE RacewayConstantsT<Lane> at(const Lane &cos_angle) const
  {
    const bool radial = !any(1.0 - cos_angle >= 1e-12);
    Lane v[n_constants];
    if (radial) {
      for (int k = 0; k < n_constants; ++k) v[k] = all_lanes(packed_radial_[k]);
    } else {
      for (int i = 0; i < lanes; ++i) {
        const Packed one = pack(at(cos_angle[i]));
        for (int k = 0; k < n_constants; ++k) v[k][i] = one[k];
      }
    }
    return {v[0],  v[1], v[2], v[3], FilmPairT<Lane>{{v[4], v[5], v[6]}, {v[7], v[8], v[9]}},
            v[10], v[11]};
  }

 private:
  RacewayConstants oblique(double cos_angle) const
  {
    const double x = cos_angle * cells;
    int i = static_cast<int>(x);
    if (i > cells - 1) i = cells - 1;
    const double s = x - i;
    // Lagrange weights on nodes -1, 0, 1, 2
    const double w0 = -s * (s - 1.0) * (s - 2.0) / 6.0,
                 w1 = (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0;
    const double w2 = -(s + 1.0) * s * (s - 2.0) / 2.0, w3 = (s + 1.0) * s * (s - 1.0) / 6.0;
    Packed v;
    for (int k = 0; k < n_constants; ++k)
      v[k] = w0 * grid_[i][k] + w1 * grid_[i + 1][k] + w2 * grid_[i + 2][k] + w3 * grid_[i + 3][k];
    return unpack(v);
  }

  static constexpr int cells = 64, n_constants = 12;
  using Packed = std::array<double, n_constants>;

  static Packed pack(const RacewayConstants &c)
  {
    return {c.K,
            c.a,
            c.b,
            c.p,
            c.film.min.lnA,
            c.film.min.p,
            c.film.min.m,
            c.film.central.lnA,
            c.film.central.p,
            c.film.central.m,
            c.film_damper,
            c.unit};
  }
  static RacewayConstants unpack(const Packed &v)
  {
    return {v[0], v[1], v[2], v[3], FilmPair{{v[4], v[5], v[6]}, {v[7], v[8], v[9]}}, v[10], v[11]};
  }

  RacewayConstants radial_{};
  Packed packed_radial_{};    // for lanes
  std::vector<Packed> grid_;
};

}    // namespace raceway

#endif
