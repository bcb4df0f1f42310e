// SPDX-License-Identifier: GPL-2.0-or-later
// What a column of an output says of itself. Computes, files, Python and the pages take it from
// here.
#ifndef RACEWAY_COLUMN_H
#define RACEWAY_COLUMN_H

#include <cmath>

namespace raceway {

// The value of a contact that is not there: a column either vanishes with it or has no value.
constexpr double vanishes = 0.0, has_none = NAN;
constexpr const char *const as_real = "%.12g", *const as_whole = "%.0f";    // as text

struct Column {
  const char *name;
  const char *unit;    // SI; empty for a plain number
  const char *meaning;
  double absent = has_none;
  const char *format = as_real;
};

// a lubricant; a fix bearing/capacitance too, and one with surroundings
enum class Needs { nothing, film, capacitance, surroundings };

}    // namespace raceway

#endif
