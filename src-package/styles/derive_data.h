// SPDX-License-Identifier: GPL-2.0-or-later
// Laws that derive missing data of bearings and oils from the given data.
#pragma once

#include "../deck/data_values.h"

namespace bearing {

// Completes the materials of balls and rings. If a file states a property of the balls alone, it is
// that of the steel of both or, if the balls are of another material, that of the rings.
void derive_materials(DataValues &, const DataValues::Map &values, const DataValues::Map &of_file);
// Derives the complete data of a bearing from its usual data.
void derive_usual_data(DataValues &);
// Derives the raceways of a bearing. If `four_point` is 0, each ring has one groove.
void derive_raceways(DataValues &);
// Returns true if an oil has the data of Vogel's or Walther's equation, and can therefore have any
// temperature.
bool follows_temperature(const DataValues::Map &);
// Derives the data of such an oil at its temperature.
void derive_oil(DataValues &);

}    // namespace bearing
