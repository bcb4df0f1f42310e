// SPDX-License-Identifier: GPL-2.0-or-later
// Numbers and lists of words as text.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace bearing {

// Rounds a value to 15 digits, as the formulas of the hosts do. A number is therefore bitwise
// identical whether it is computed in a deck or by a command.
inline std::string digits(double value)
{
  char buf[32];
  snprintf(buf, sizeof buf, "%.15g", value);
  return buf;
}

inline double written(double value) { return strtod(digits(value).c_str(), nullptr); }

inline std::vector<std::string> words_of(const std::string &text)
{
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

inline std::string joined(const std::vector<std::string> &words, const std::string &between = ", ")
{
  std::string list;
  for (const std::string &word : words) list += (&word == &words[0] ? "" : between) + word;
  return list;
}

// Calls `take(narg, arg)` with the words in the form in which the hosts pass them to commands.
template <class Take> void pass_words(std::vector<std::string> words, const Take &take)
{
  std::vector<char *> arg;
  for (std::string &word : words) arg.push_back(&word[0]);
  take(static_cast<int>(arg.size()), arg.data());
}

}    // namespace bearing
