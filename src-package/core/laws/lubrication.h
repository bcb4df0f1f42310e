// SPDX-License-Identifier: GPL-2.0-or-later
// Parameters of each kind of lubrication: the inlet length of a rolling contact, SKF's starvation
// constant K_rs, and the fraction of the space around the balls that is filled with oil
// (docs/tribology, Kinds of lubrication).
#pragma once

#include <cmath>

namespace raceway {

enum class LubricationKind { bath, jet, mist, grease, minimal };
constexpr const char *lubrication_kinds = "bath jet mist grease minimal";

struct Lubrication {
  double inlet = 0.0;            // inlet length divided by the semi-axis b; 0: flooded, 1: shortest
                                 // inlet
  double replenishment = 0.0;    // K_rs; 0: no starvation
  double share = 0.0;            // X, volume fraction of oil
};

// Returns the fraction of the balls' volume below the level of an oil bath at rest, averaged over
// the orbit. The level is measured from the lowest point of the raceway, in ball diameters; `pitch`
// is the pitch radius in ball radii.
inline double immersed_share(double level, double pitch)
{
  constexpr int points = 720;
  double sum = 0.0;
  for (int k = 0; k < points; ++k) {
    const double azimuth = 3.14159265358979323846 * (k + 0.5) / points;
    // depth of the ball's centre below the oil surface, in ball radii
    const double depth = pitch * (std::cos(azimuth) - 1.0) - 1.0 + 2.0 * level;
    const double x = std::fmax(-1.0, std::fmin(depth, 1.0));
    sum += 0.25 * (2.0 + 3.0 * x - x * x * x);
  }
  return sum / points;
}

// Returns the parameters for a kind of lubrication; `level` and `pitch` are defined above,
// `density` is that of the oil in kg/m^3.
inline Lubrication lubrication(LubricationKind kind, double level, double pitch, double density)
{
  constexpr double groove = 3.0;    // inlet length in the groove of a bearing (Balan et al. 2015)
  constexpr double oil = 3e-8, grease = 6e-8;          // K_rs, SKF
  const double air = std::fmin(1.2 / density, 1.0);    // ratio of the density of air to that of oil
  switch (kind) {
    case LubricationKind::bath: {
      const double share = immersed_share(level, pitch);
      const bool all = share > 1.0 - 1e-9;
      // SKF's factor applies to oil levels up to the centre of the lowest ball
      return {all ? 0.0 : groove, level > 0.5 ? 0.0 : oil, share > air ? share : air};
    }
    case LubricationKind::jet:    // SKF: twice the drag in a bath that reaches the centre of the
                                  // lowest ball
      return {groove, oil, 2.0 * immersed_share(0.5, pitch)};
    default: return {1.0, grease, air};
  }
}

}    // namespace raceway
