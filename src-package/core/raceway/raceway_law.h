// SPDX-License-Identifier: GPL-2.0-or-later
// Constants of the contacts with one raceway as functions of the contact angle.
//
// The effective radii depend on the contact angle (docs/theory, Geometry), and so do the stiffness,
// the ellipse and the film exponents. They depend only on cos(alpha). They are therefore computed
// once on a uniform grid of cos(alpha) in [0, 1] and interpolated by a four-point cubic, with a
// relative error below 1e-9 (tested). If the load is purely radial, cos(alpha) remains 1, and the
// constants at that node are used directly.
#pragma once

#include "../geometry/groove.h"
#include "../laws/damping.h"
#include "../laws/film.h"
#include "../laws/hertz.h"

#include <vector>

namespace raceway {

template <class T> struct alignas(sizeof(T)) RacewayConstantsT {
  T K;                  // N/m^1.5
  T a, b;               // sqrt(m), semi-axes divided by sqrt(overlap)
  T p;                  // Pa/sqrt(m)
  FilmPairT<T> film;    // h_min, h_c
  T film_damper;        // N s/m^0.5, C_fluid = film_damper * a sqrt(overlap) * h^-1.5
  T unit;               // m, compression at a load of 1 N, K^(-2/3)
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

// Returns the exact constants at one contact angle.
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

// Returns the constants as an array.
template <class T> RACEWAY_INLINE T *numbers(RacewayConstantsT<T> &c)
{
  return reinterpret_cast<T *>(&c);
}
template <class T> RACEWAY_INLINE const T *numbers(const RacewayConstantsT<T> &c)
{
  return reinterpret_cast<const T *>(&c);
}

class RacewayLaw {
 public:
  RacewayLaw() = default;
  RacewayLaw(const Groove &g, double pitch_radius, const RacewayMaterial &mat,
             const RacewayModel &model) :
      radial_(raceway_constants(g, pitch_radius, mat, model, 1.0)), grid_(cells + 3)
  {
    // with one more node beyond each end, so that every cell has four points
    for (int i = 0; i < cells + 3; ++i)
      grid_[i] = raceway_constants(g, pitch_radius, mat, model, double(i - 1) / cells);
  }

  const RacewayConstants &radial() const { return radial_; }

  // Returns the constants at cos(alpha); within 1e-12 of cos(alpha) = 1, they are equal to the
  // radial constants to rounding accuracy.
  RACEWAY_INLINE RacewayConstants at(double cos_angle) const
  {
    return 1.0 - cos_angle < 1e-12 ? radial_ : oblique(cos_angle);
  }

  RACEWAY_INLINE RacewayConstantsT<Lane> at(const Lane &cos_angle) const
  {
    RacewayConstantsT<Lane> c;
    Lane *const of_all = numbers(c);
    if (!any(1.0 - cos_angle >= 1e-12)) {
      for (int k = 0; k < n_constants; ++k) of_all[k] = all_lanes(numbers(radial_)[k]);
    } else {
      for (int i = 0; i < lanes; ++i) {
        const RacewayConstants one = at(cos_angle[i]);
        for (int k = 0; k < n_constants; ++k) of_all[k][i] = numbers(one)[k];
      }
    }
    return c;
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
    const double *const a = numbers(grid_[i]), *const b = numbers(grid_[i + 1]),
                        *const c = numbers(grid_[i + 2]), *const d = numbers(grid_[i + 3]);
    RacewayConstants found;
    for (int k = 0; k < n_constants; ++k)
      numbers(found)[k] = w0 * a[k] + w1 * b[k] + w2 * c[k] + w3 * d[k];
    return found;
  }

  static constexpr int cells = 64;
  static constexpr int n_constants = sizeof(RacewayConstants) / sizeof(double);
  static_assert(sizeof(RacewayConstantsT<Lane>) == n_constants * sizeof(Lane),
                "nothing but numbers of type T");

  RacewayConstants radial_{};
  std::vector<RacewayConstants> grid_;
};

}    // namespace raceway
