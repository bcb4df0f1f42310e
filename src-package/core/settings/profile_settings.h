// SPDX-License-Identifier: GPL-2.0-or-later
// Flaws and waviness of raceways or balls, as set in a deck.
#ifndef BEARING_PROFILE_SETTINGS_H
#define BEARING_PROFILE_SETTINGS_H

#include "../geometry/ball_profile.h"
#include "../geometry/raceway_profile.h"
#include "arguments.h"

namespace bearing {

struct ProfileSettings {
  int groove = 0;                   // number of the groove of each ring
  raceway::ProfileShape raceway;    // departure from the torus
  bool of_balls = false;
  raceway::BallShape ball;            // departure from the sphere
  std::vector<std::string> flawed;    // numbers of the flawed balls; empty: all balls of the group

  bool departs() const
  {
    return !(raceway.notches.empty() && raceway.waves.empty() && raceway.tables.empty() &&
             ball.pits.empty() && ball.waves.empty() && ball.tables.empty());
  }

  // Reads all words of a fix bearing/profile. most_grooves: largest number of grooves per ring;
  // said: receives the words of the profile alone.
  static ProfileSettings read(Arguments &, int most_grooves, std::vector<std::string> &said);
};

}    // namespace bearing

#endif
