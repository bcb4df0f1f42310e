// SPDX-License-Identifier: GPL-2.0-or-later
// EHD film thickness of a smooth elliptical contact (docs/theory, Film; Farah 2020 eqs 6, 7, 9).
//
// All laws here have the form h/R_x = c U^p G^g W^m (1 - k1 exp(-k2 kappa)) with
//   U = eta u/(E' R_x),  G = xi E',  W = Q/(E' R_x^2),
// and kappa is constant for a given raceway and contact angle, so ln h = lnA + p ln u + m ln Q. The
// constants are computed once, so that evaluating a contact costs only two logarithms and one
// exponential.
//   u entrainment speed, m/s;  Q elastic contact load, N;  h in m.
// Sources: Masjedi & Khonsari 2015 (smooth part, point contact); Hamrock & Dowson 1977.
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

enum class FilmModel { masjedi_khonsari, masjedi_khonsari_printed, hamrock_dowson };

struct Lubricant {
  double viscosity = 0.0;             // Pa s, at operating temperature and ambient pressure
  double pressure_viscosity = 0.0;    // 1/Pa
};

template <class T> struct FilmLawT {
  T lnA = T();    // ln of the prefactor in SI units
  T p = T();      // exponent of the entrainment speed
  T m = T();      // exponent of the load (negative)
};
using FilmLaw = FilmLawT<double>;

template <class T> struct FilmPairT {
  FilmLawT<T> min, central;
};
using FilmPair = FilmPairT<double>;

namespace detail {
inline FilmLaw film_law(double c, double p, double g, double m, double side_leakage,
                        const Lubricant &oil, double Eprime, double Rx)
{
  FilmLaw f;
  f.p = p;
  f.m = m;
  f.lnA = std::log(Rx * c * side_leakage) + p * std::log(oil.viscosity / (Eprime * Rx)) +
          g * std::log(oil.pressure_viscosity * Eprime) - m * std::log(Eprime * Rx * Rx);
  return f;
}
}    // namespace detail

inline FilmPair film_laws(FilmModel model, double kappa, const Lubricant &oil, double Eprime,
                          double Rx)
{
  FilmPair f;
  if (model == FilmModel::hamrock_dowson) {
    f.min =
        detail::film_law(3.63, 0.68, 0.49, -0.073, 1.0 - std::exp(-0.68 * kappa), oil, Eprime, Rx);
    f.central = detail::film_law(2.69, 0.67, 0.53, -0.067, 1.0 - 0.61 * std::exp(-0.73 * kappa),
                                 oil, Eprime, Rx);
    return f;
  }
  // eq 6 is used as printed; in eq 9 the exponents of kappa are positive (errata) or negative (as
  // printed)
  const double sign = model == FilmModel::masjedi_khonsari_printed ? -1.0 : 1.0;
  f.min = detail::film_law(1.637, 0.711 * std::pow(kappa, -0.023), 0.65 * std::pow(kappa, -0.045),
                           -0.09 * std::pow(kappa, -0.15), 1.0 - 0.974 * std::exp(-0.676 * kappa),
                           oil, Eprime, Rx);
  f.central =
      detail::film_law(3.672, 0.663 * std::pow(kappa, sign * 0.025),
                       0.502 * std::pow(kappa, sign * 0.064), -0.045 * std::pow(kappa, sign * 0.18),
                       1.0 - 0.573 * std::exp(-0.74 * kappa), oil, Eprime, Rx);
  return f;
}

// Input for the minimum and the central film thickness of a contact.
template <class T> struct FilmPointT {
  T ln_speed, ln_load;
};

template <class T> RACEWAY_INLINE FilmPointT<T> film_point(const T &speed, const T &load)
{
  return {logarithm(speed), logarithm(load)};
}

// Returns the logarithm of the film thickness h (m).
template <class T> RACEWAY_INLINE T ln_film_thickness(const FilmLawT<T> &f, const FilmPointT<T> &at)
{
  return f.lnA + f.p * at.ln_speed + f.m * at.ln_load;
}

// Returns the film thickness h, m. It is 0 at zero speed, because there is no film at rest.
template <class T> RACEWAY_INLINE T film_thickness(const FilmLawT<T> &f, const FilmPointT<T> &at)
{
  return exponential(ln_film_thickness(f, at));
}

// Returns the composite roughness sqrt(s1^2 + s2^2), m. The lambda ratio Lambda is h_min divided by
// it (eq 7).
inline double composite_roughness(double s1, double s2) { return std::sqrt(s1 * s1 + s2 * s2); }

}    // namespace raceway
