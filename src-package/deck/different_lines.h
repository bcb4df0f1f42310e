// SPDX-License-Identifier: GPL-2.0-or-later
// Finds the first difference between two decks that are given as lists of command lines.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace bearing {

// Returns, for each list, its first line that is missing in the other list, or an empty string if
// there is none. If both lists have such a line, the two lines are shortened to the words that
// differ.
std::pair<std::string, std::string> different_lines(const std::vector<std::string> &one,
                                                    const std::vector<std::string> &other);

}    // namespace bearing
