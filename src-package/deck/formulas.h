// SPDX-License-Identifier: GPL-2.0-or-later
// Collects the formulas of the variables to which commands of a deck refer as v_NAME, directly or
// through other formulas. A continued run compares them with the formulas in its restart file.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace bearing {

// Returns a line `variable NAME = TEXT` for each variable, in the order of the commands. TEXT is
// the formula of an equal- or atom-style variable or the value of an index- or string-style
// variable. Variables of other styles are omitted, because their values change or have to be
// computed.
std::vector<std::string> formulas(LAMMPS_NS::LAMMPS *, const std::vector<std::string> &commands);

}    // namespace bearing
