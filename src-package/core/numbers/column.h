// SPDX-License-Identifier: GPL-2.0-or-later
// Description of an output column, used by computes, Python and the documentation pages.
#pragma once

#include <cmath>

namespace raceway {

// Value in a column if there is no contact: zero, or no value.
constexpr double vanishes = 0.0, has_none = NAN;
constexpr const char *const as_real = "%.12g", *const as_whole = "%.0f";    // printf formats for
                                                                            // values in text files

struct Column {
  const char *name;
  const char *unit;    // SI; empty for a plain number
  const char *meaning;
  double absent = has_none;
  const char *format = as_real;
};

// Requirement of a column: a lubricant (film), a lubricant and a fix bearing/capacitance, or a
// lubricant and a fix bearing/capacitance with surroundings.
enum class Needs { nothing, film, capacitance, surroundings };

}    // namespace raceway
