// SPDX-License-Identifier: GPL-2.0-or-later
// The kind of cage that `cage auto` stands for, in the decks and in the commands of Python.
#pragma once

#include <string>

namespace bearing {

// Returns ring for the models `full`, implicit steps and a lubricant, without which balls strike
// their pockets, unless the bearing has data of cage balls. Otherwise returns chain.
inline const char *usual_cage(const std::string &models, const std::string &integrator,
                              const std::string &lubricant, bool cage_balls)
{
  const bool ring = models == "full" && integrator == "implicit" && lubricant != "dry";
  return ring && !cage_balls ? "ring" : "chain";
}

}    // namespace bearing
