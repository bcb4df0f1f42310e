// SPDX-License-Identifier: GPL-2.0-or-later
// Computes the fraction of the contact load that is carried by asperities, L_a = exp(-B Lambda^C)
// (Zhou and Hoeprich 1991, in Schwarz et al., Lubricants 2023, 11, 369; measured on roller
// bearings) or L_a = 1 - erf(Lambda) (Clarke et al. 2016), and the resulting friction coefficient
// mu = L_a mu_b + (1 - L_a) mu_film (docs/tribology, Load sharing with asperities).
#pragma once

#include "../numbers/exp_log.h"

namespace raceway {

enum class AsperityLaw { zhou, clarke };

struct Asperities {
  double b = 2.1, c = 0.85;    // fitted constants for a composite roughness of 0.1 um
  AsperityLaw law = AsperityLaw::zhou;
};

// Returns 1 - erf(x) for x >= 0, accurate to 1.5e-7 (Abramowitz and Stegun 7.1.26).
template <class T> RACEWAY_INLINE T complementary_error(const T &x)
{
  const T t = 1.0 / (1.0 + 0.3275911 * x);
  const T sum = t * (0.254829592 +
                     t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return sum * exponential(T(-x * x));
}

// Returns the asperity fraction L_a from ln Lambda. The fraction is 1 if there is no film.
template <class T> RACEWAY_INLINE T asperity_share(const Asperities &own, const T &ln_lambda)
{
  if (own.law == AsperityLaw::clarke) return complementary_error(exponential(ln_lambda));
  return exponential(T(-own.b * exponential(T(own.c * ln_lambda))));
}

// Returns the friction coefficient mu of a contact whose asperities carry the fraction L_a of the
// load.
template <class Film, class T>
RACEWAY_INLINE T mixed_friction(double boundary, const Film &film, const T &share)
{
  return film + (boundary - film) * share;
}

}    // namespace raceway
