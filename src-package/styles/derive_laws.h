// SPDX-License-Identifier: GPL-2.0-or-later
// Laws that derive missing data of bearings and oils from the given data.
#pragma once

#include "../deck/data_values.h"

#include <map>

namespace bearing {

typedef std::map<std::string, void (*)(DataValues &)> DeriveLaws;

DeriveLaws data_laws();

}    // namespace bearing
