// SPDX-License-Identifier: GPL-2.0-or-later
// Values with 15 digits, as written by the formulas of the hosts. A number is therefore bitwise
// identical whether it is computed by a deck or by a command.
#ifndef BEARING_WRITTEN_H
#define BEARING_WRITTEN_H

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

#endif
