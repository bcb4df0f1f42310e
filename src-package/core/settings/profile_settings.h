// SPDX-License-Identifier: GPL-2.0-or-later
// Flaws and waviness of raceways or balls, as specified in a deck.
#pragma once

#include "../geometry/ball_profile.h"
#include "../geometry/raceway_profile.h"
#include "arguments.h"

namespace bearing {

struct ProfileSettings {
  int groove = 0;                   // index of the groove on each ring
  raceway::ProfileShape raceway;    // deviation from the torus
  bool of_balls = false;
  raceway::BallShape ball;            // deviation from the sphere
  std::vector<std::string> flawed;    // numbers of the flawed balls; empty for all balls

  bool departs() const
  {
    return !(raceway.notches.empty() && raceway.waves.empty() && raceway.tables.empty() &&
             ball.pits.empty() && ball.waves.empty() && ball.tables.empty());
  }

  // Reads all words of a fix bearing/profile command. `most_grooves` is the largest number of
  // grooves per ring. Only the words of the profile are written to `said`.
  static ProfileSettings read(Arguments &, int most_grooves, std::vector<std::string> &said);
};

}    // namespace bearing
