// SPDX-License-Identifier: GPL-2.0-or-later
// The laws of bearing_derive.
#ifndef BEARING_DERIVE_LAWS_H
#define BEARING_DERIVE_LAWS_H

#include "../deck/data_values.h"

#include <map>

namespace bearing {

typedef std::map<std::string, void (*)(DataValues &)> DeriveLaws;

DeriveLaws data_laws();    // laws of bearings and oils
DeriveLaws run_laws();     // laws of loads, motion, steps and samples

}    // namespace bearing

#endif
