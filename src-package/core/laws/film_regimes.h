// SPDX-License-Identifier: GPL-2.0-or-later
// Central film thickness in all lubrication regimes, from a rigid isoviscous to an elastic
// piezoviscous contact (Nijenbanning, Venner, Moes 1994; docs/tribology, Film in the gap). It
// remains valid as the load goes to zero, unlike the power laws of film.h.
//
// With U = 2 eta u/(E' R_x), M = Q/(E' R_x^2) U^(-3/4), L = xi E' U^(1/4), lambda = R_x/R_y:
//   h = R_x sqrt(U) {[RI^1.5 + (EI^-4 + H_0^-4)^(-3/8)]^(2s/3) + (RP^-8 + EP^-8)^(-s/8)}^(1/s),
//   s = 1.5 (1 + e^(-1.2 EI/EP)).
// The code works with logarithms, because the asymptotes are straight lines as functions of ln M.
#pragma once

#include "../numbers/exp_log.h"
#include "film.h"

namespace raceway {

// Film thickness at a given load; `fall` is -d(ln h)/d(ln Q).
template <class T> struct FilmAtLoadT {
  T thickness, fall;    // m, 1
};

// Logarithms of the geometry factors of the asymptotes, at M = L = 1.
template <class T> struct MoesShapeT {
  T radius;            // ln of R_x in m
  T ri, rp, ei, ep;    // ln of the factors of RI, RP, EI, EP
  T limit;             // ln of the factor of H_0
};

template <class T>
RACEWAY_INLINE MoesShapeT<T> moes_shape(const T &rolling_radius, double ln_transverse)
{
  const T ln_x = logarithm(rolling_radius), l = ln_x - ln_transverse;
  const T wide = logarithm(T(1.0 + 0.006 * l + 0.63 * exponential(T(l * (4.0 / 7.0)))));
  const T ri = std::log(145.0) - l -
               15.0 / 7.0 * logarithm(T(1.0 + 0.796 * exponential(T(l * (14.0 / 15.0)))));
  const T rp = std::log(1.29) - 2.0 / 3.0 * logarithm(T(1.0 + 0.691 * exponential(l)));
  return {ln_x,
          ri,
          rp,
          std::log(3.18) - 14.0 / 25.0 * wide - l * (1.0 / 15.0),
          std::log(1.48) - 7.0 / 20.0 * wide - l * (1.0 / 24.0),
          std::log(1.8) - l};
}

// Constants of a raceway that do not change during a run.
struct MoesRaceway {
  double ln_speed = 0.0, ln_material = 0.0;        // ln of 2 eta/E' and of xi E'
  double ln_modulus = 0.0, ln_transverse = 0.0;    // ln of E' and R_y
  MoesShapeT<double> radial{};                     // at zero contact angle

  MoesRaceway() = default;
  MoesRaceway(const Lubricant &oil, double modulus, double rolling_radius, double transverse) :
      ln_speed(std::log(2.0 * oil.viscosity / modulus)),
      ln_material(std::log(oil.pressure_viscosity * modulus)), ln_modulus(std::log(modulus)),
      ln_transverse(std::log(transverse)), radial(moes_shape(rolling_radius, ln_transverse))
  {
  }

  // Returns the geometry factors at a contact angle. At zero angle they are exact, as are the
  // constants of a raceway.
  template <class T>
  RACEWAY_INLINE MoesShapeT<T> shape(const T &cos_angle, const T &rolling_radius,
                                     double radial_radius) const
  {
    const auto oblique = 1.0 - cos_angle >= 1e-12;
    if (any(oblique))
      return moes_shape(T(where(oblique, rolling_radius, radial_radius)), ln_transverse);
    const T n = T();
    return {n + radial.radius, n + radial.ri, n + radial.rp,
            n + radial.ei,     n + radial.ep, n + radial.limit};
  }
};

// Film thickness of one contact at one entrainment speed (m/s, not zero) as a function of the
// logarithm of its load.
template <class T> class MoesFilmT {
 public:
  MoesFilmT() = default;
  // ln_factor is the logarithm of a factor by which the film thickness is multiplied.
  RACEWAY_INLINE MoesFilmT(const MoesRaceway &k, const MoesShapeT<T> &shape, const T &ln_u,
                           const T &ln_factor)
  {
    const T speed = k.ln_speed + ln_u - shape.radius, L = k.ln_material + 0.25 * speed;
    unit_ = k.ln_modulus + 2.0 * shape.radius + 0.75 * speed;
    scale_ = shape.radius + 0.5 * speed + ln_factor;
    rigid_ = 1.5 * shape.ri;
    piezo_ = exponential(T(-8.0 * (shape.rp + L * (2.0 / 3.0))));
    ei_ = shape.ei;
    ep_ = shape.ep + 0.75 * L;
    limit_ = exponential(T(-4.0 * shape.limit));
    ri_ = shape.ri;
    widest_ = shape.limit + scale_;
  }

  RACEWAY_INLINE FilmAtLoadT<T> at(const T &ln_load) const
  {
    const T M = ln_load - unit_, ei = ei_ - M * (2.0 / 15.0), ep = ep_ - M * (1.0 / 12.0);
    const T soft = exponential(T(-4.0 * ei)), bent = soft + limit_;
    const T rigid = exponential(T(rigid_ - 3.0 * M));
    const T elastic = exponential(T(-0.375 * logarithm(bent))), iso = rigid + elastic;
    const T iso_fall = (3.0 * rigid + 0.2 * elastic * soft / bent) / iso;
    const T ratio = exponential(T(ei - ep)), drop = exponential(T(-1.2 * ratio));
    const T s = 1.5 + 1.5 * drop, s_rise = 0.09 * drop * ratio;
    const T deep = exponential(T(-8.0 * ep)), both = piezo_ + deep;
    const T a = logarithm(iso) * (2.0 / 3.0), b = logarithm(both) * -0.125;
    const T more = exponential(T(s * (b - a))), part = more / (1.0 + more);
    const T ln_H = a + logarithm(T(1.0 + more)) / s, mean = a + part * (b - a);
    const T fall = (1.0 - part) * iso_fall * (2.0 / 3.0) + part * deep / both * (1.0 / 12.0) -
                   s_rise * (mean - ln_H) / s;
    return {exponential(T(scale_ + ln_H)), fall};
  }

  // Returns the logarithm of the load at which a rigid contact has a film of thickness e^ln_h. This
  // is a lower bound on the load at which the contact has that film.
  RACEWAY_INLINE T below(const T &ln_h) const { return unit_ + 0.5 * (ri_ - (ln_h - scale_)); }
  // Returns the logarithm of the film thickness that can be exceeded only by a rigid contact.
  RACEWAY_INLINE T widest() const { return widest_; }

 private:
  T unit_, scale_, rigid_, piezo_, ei_, ep_, limit_, ri_, widest_;
};

}    // namespace raceway
