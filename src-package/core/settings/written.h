// SPDX-License-Identifier: GPL-2.0-or-later
// Rounds values to 15 digits, as the formulas of the hosts do. A number is therefore bitwise
// identical whether it is computed in a deck or by a command.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

namespace bearing {

inline std::string digits(double value)
{
  char buf[32];
  snprintf(buf, sizeof buf, "%.15g", value);
  return buf;
}

inline double written(double value) { return strtod(digits(value).c_str(), nullptr); }

}    // namespace bearing
